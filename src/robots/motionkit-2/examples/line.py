# Follow a line
# Two sensors look at the ground: 1 means light, 0 means dark.
# Put the robot on a black line, for example in the course
# “Closed line”.
from callimk import *

setSpeed(25)

while True:
    left_bright = irLeftValue()
    right_bright = irRightValue()
    if left_bright == 0 and right_bright == 0:
        forward()           # both on the line
    elif left_bright == 0:
        leftArc(0.1)        # the line is on the left
    elif right_bright == 0:
        rightArc(0.1)       # the line is on the right
    delay(10)
