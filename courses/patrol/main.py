# Patrol with junctions
# The robot follows the line by itself. The program only says where to go at each kind of junction.
from mbrobot_plusV3 import *

LEFT = 1
RIGHT = 2
STRAIGHT = 3
CROSSING = 1            # what intersectionDetecting() says at a crossing

setPatrolSpeed(3)
setIntersectionRunMode(STRAIGHT)
setTRordRunMode(RIGHT)
setLeftOrStraightRunMode(LEFT)
setRightOrStraightRunMode(STRAIGHT)
patrolling(1)

while intersectionDetecting() != CROSSING:
    delay(20)
while intersectionDetecting() == CROSSING:
    delay(20)
setIntersectionRunMode(LEFT)    # the first crossing lies behind it: left at the next one
