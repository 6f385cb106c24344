# The leader follows the line. Now and then it takes a break.
from mbrobot import *

setSpeed(35)
steps = 0

while True:
    left_bright = irLeft.read_digital()
    right_bright = irRight.read_digital()
    if not left_bright and not right_bright:
        forward()
    elif not left_bright:
        leftArc(0.1)
    elif not right_bright:
        rightArc(0.1)
    else:
        forward()
    delay(10)
    steps += 1
    if steps % 400 == 0:
        stop()
        delay(2000)
