# Lights on both arms
# Lights 0 to 5 are on the left arm, 6 to 11 on the right one, each from back to front.
from mbbitbot import *

display.show(Image.HAPPY)

for turn in range(4):
    for step in range(6):           # one light runs forward on each arm
        fill(0, 0, 0)
        set_led(step, 80, 0, 60)
        set_led(6 + step, 0, 60, 80)
        sleep(150)

for blink in range(3):              # left indicator
    for light in range(6):
        set_led(light, 80, 40, 0)
    sleep(400)
    fill(0, 0, 0)
    sleep(400)
