# Two traffic lights
# Task: drive to the target. While a red lamp shines, you wait at its stop line.
from mbrobot_plusV2 import *
from microbit import display

def is_dark(sensor):
    return sensor.read_digital() == 0

def follow_line():
    """Along the line, until the outer sensors see a stop line."""
    while not (is_dark(irL2) or is_dark(irR2)):
        if is_dark(irL1) and not is_dark(irR1):
            leftArc(0.2)
        elif is_dark(irR1) and not is_dark(irL1):
            rightArc(0.2)
        else:
            forward()
        delay(10)
    stop()

setSpeed(60)
follow_line()
# You are at the stop line. How bright is it with the lamp, and how bright without it?
while True:
    print(display.read_light_level())
    delay(500)
