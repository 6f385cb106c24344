# Follow the line
# Two sensors look at the floor below the robot. They give 1 on light and 0 on dark ground.
# On the line both sensors see dark.
from mbrobot import *

setSpeed(40)

while True:
    left_bright = irLeft.read_digital()
    right_bright = irRight.read_digital()
    if not left_bright and not right_bright:
        forward()           # in the middle of the line
    elif not left_bright:
        leftArc(0.06)       # the line lies to the left
    elif not right_bright:
        rightArc(0.06)      # the line lies to the right
    # else: line lost, go on as before
    delay(10)
