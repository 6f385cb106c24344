# Bends and an S
# Task: follow the line through all its bends and come back to the start.
# This program loses the line in tight bends. Why? Make it better.
from mbrobot import *

setSpeed(50)

while True:
    left_bright = irLeft.read_digital()
    right_bright = irRight.read_digital()
    if not left_bright and right_bright:
        leftArc(0.2)        # the line is on the left
    elif left_bright and not right_bright:
        rightArc(0.2)       # the line is on the right
    else:
        forward()
    delay(10)
