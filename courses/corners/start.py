# Line with corners
# Task: follow the line around all its corners and come back to the start.
# The sensors irL2, irL1, irM, irR1 and irR2 report 1 on light and 0 on dark ground.
# Hint: irL2 and irR2 are the outer ones. They see dark only at a corner.
from mbrobot_plusV2 import *

setSpeed(40)

while True:
    if irL1.read_digital() == 0 and irR1.read_digital() == 1:
        leftArc(0.1)        # the line is on the left
    elif irR1.read_digital() == 0 and irL1.read_digital() == 1:
        rightArc(0.1)       # the line is on the right
    else:
        forward()
    # And at the corners? Complete the program.
    delay(10)
