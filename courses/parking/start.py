# Parking
# Task: park backwards in the space without touching anything.
# The black line shows where to stop and turn. irM reports 0 on dark ground.
from mbrobot_plusV2 import *

setSpeed(40)

forward()
while irM.read_digital() == 1:
    delay(5)
stop()
# Now the robot stands beside the space. How does it get in backwards?
