# Along the wall
# Columns 0 to 2 of the lidar look ahead to the left: from their distances the robot knows how far the wall beside it is.
from mbrobot_plusV3 import *

NEAR = 30               # centimetres to the left: nearer than this it steers to the right
FAR = 38                # farther than this it steers to the left
FRONT = 24              # centimetres straight ahead: here it turns on the spot

while True:
    row = getDistanceRow(3)
    left = min(row[0:3])
    if min(row[3:6]) < FRONT:
        motL.rotate(60)
        motR.rotate(-60)
    elif left < NEAR:
        motL.rotate(100)
        motR.rotate(50)
    elif left > FAR:
        motL.rotate(85)
        motR.rotate(100)
    else:
        motL.rotate(100)
        motR.rotate(100)
    delay(20)
