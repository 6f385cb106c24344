import { ColumnWriter, WORDS } from './columns';

/**
 * Likely words of programs and courses. In version 1 of links this is deflate's dictionary for the words, which then
 * only name the place; in version 2 the model has read it before the first word. No character may ever change.
 */
export const LIKELY_TEXT = `import music
import radio
import neopixel
import random
from microbit import Image, button_b, display, pin0, pin1, pin2, sleep
from calliopemini import *
from callibot import *
from mbrobotmot import *
from mbrobot_plus import *
from mbrobot_plusV2 import *
import math
    global 
class :
    def __init__(self, 
try:
except 
    return 
    pass
for i in range(10):
    break
print(str(len(
not  and  or False None
running_time()
accelerometer.get_x()
microphone.sound_level()
compass.heading()
display.scroll("display.clear()
Image.ARROW_N
Image.HAPPY
read_analog(write_digital(1)write_analog(
button_b.is_pressed()
button_a.was_pressed():
motL.rotate(motR.rotate(fillRGB(setLED(setServo(setAlarm(posRGB(
ir_read_values_as_byte()
    links = rechts = left = right = distanz = distance = abstand = 
# Linie line Hindernis wall Wand fahren drive drehen turn stehen bleiben warten wait zurück back langsam schnell
isDriving()
rightArc(0.leftArc(0.backward()
stop()
left()
right()
forward()
setSpeed(getDistance() < > 0 and irRight.read_digital() == 1irLeft.read_digital() == 0:
    elif 
    else:
        delay(100)
    if 
    sleep(
while True:
wall-1block-fixed-stroke-target-checkpoint-forbidden-spikes-mover-label-closed-line
main.pyfrom microbit import *
from mbrobot import *
`;

/** The dictionary as bytes, a varint a character as the words themselves. */
export const LIKELY_WORDS: Uint8Array = bytesOf(LIKELY_TEXT);

function bytesOf(text: string): Uint8Array {
  const out = new ColumnWriter();
  for (let index = 0; index < text.length; index += 1) out.uint(WORDS, text.charCodeAt(index));
  return out.bytes().words;
}
