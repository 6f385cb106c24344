# Do not bump
# The robot drives until something is nearer than 15 cm.
# Then it turns away.
# Button A stops it.
from microbit import *
from mbrobot_plusV2 import *

setSpeed(50)

while not button_a.was_pressed():
    distance = getDistance()
    if distance < 15:
        fillRGB(80, 0, 0)
        backward()
        delay(300)
        right()
        delay(700)
    else:
        fillRGB(0, 60, 0)
        forward()
    delay(50)

stop()
clearRGB()
