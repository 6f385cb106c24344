# Headlights in the dark
# Below the picture of the board you set how bright it is: in the dark the lights go on.
from mbbitbot import *

DARK = 200              # of 1023

while True:
    brightness = (getLight(0) + getLight(1)) / 2
    if brightness < DARK:
        set_led(5, 90, 90, 70)
        set_led(11, 90, 90, 70)
    else:
        fill(0, 0, 0)
    sleep(200)
