# Follow a line
# The two sensors in the middle see the line:
# the robot steers to where it is dark.
from mbrobot_plus import *

setSpeed(40)
forward()

while True:
    left_light = irL1.read_digital()
    right_light = irR1.read_digital()
    if left_light and not right_light:
        rightArc(0.1)
    elif right_light and not left_light:
        leftArc(0.1)
    elif not left_light:
        forward()
    # Where both see light ground, the robot goes on as before:
    # so it finds the line again.
    delay(10)
