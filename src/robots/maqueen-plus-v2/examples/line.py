# Follow a line
# The middle sensor shall stay on the black line:
# 0 means dark, 1 means light.
from mbrobot_plusV2 import *

setSpeed(40)

while True:
    if irL1.read_digital() == 0:        # the line is on the left
        leftArc(0.06)
    elif irR1.read_digital() == 0:      # the line is on the right
        rightArc(0.06)
    elif irM.read_digital() == 0:       # the line is in the middle
        forward()
    delay(10)
