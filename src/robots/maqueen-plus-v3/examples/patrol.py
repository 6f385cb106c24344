# Patrol
# The robot follows the line by itself. Meanwhile the program shows colours.
from mbrobot_plusV3 import *

setPatrolSpeed(2)               # 1 is slow, 5 is fast
patrolling(1)

for color in range(1, 8):
    setLED(color)
    delay(2000)
    print(readRealTimeSpeed(1), "cm/s")

patrolling(2)                   # stops
setLED(0)
