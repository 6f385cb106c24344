# Bump and turn away
# The robot drives until it bumps into something.
# Then it backs off, turns away and drives on.
from callibot import *


def back_off(turn):
    backward()
    delay(600)
    turn()
    delay(350)
    setLED(0)
    forward()


setSpeed(40)
setLED(0)
forward()

while True:
    if tsLeftValue():       # bumped on the left: turn right
        setLEDLeft(1)
        back_off(right)
    elif tsRightValue():    # bumped on the right: turn left
        setLEDRight(1)
        back_off(left)
    elif tsValue():         # drove straight into the wall
        setLED(1)
        back_off(right)
    delay(20)
