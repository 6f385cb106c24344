# The way out of the room
# Task: find the door, drive through it and on to the target, without touching anything.
# Beware: behind the door lies something low. Row 3 of the lidar looks over it, row 6 sees it.
from mbrobot_plusV3 import *

for i in range(4):
    print(i * 90, getDistanceRow(3))    # from left to right, in centimetres
    pidControlAngle(90, 1)              # 90 degrees to the right, then go on

# Where is the door? Complete the program.
