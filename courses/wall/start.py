# Along the wall
# Task: follow the wall on your left, through checkpoints 1 to 3 to the target, without touching anything.
# getDistanceRow(3) gives what the lidar sees straight ahead: 8 distances in centimetres, from left to right.
from mbrobot_plusV3 import *

while True:
    row = getDistanceRow(3)
    left = min(row[0:3])
    if left > 38:
        motL.rotate(85)     # a little to the left, towards the wall
        motR.rotate(100)
    else:
        stop()              # too near: what now?
    delay(20)
