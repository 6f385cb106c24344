# Patrol with junctions
# Task: let the robot follow the line through checkpoints 1 to 3 to the target.
# At each kind of junction you say where to go: 1 left, 2 right, 3 straight on, 4 stop.
# Hint: intersectionDetecting() gives 1 at a crossing, 2 at a T, 3 and 4 at a branch, else 0.
from mbrobot_plusV3 import *

setPatrolSpeed(3)
setIntersectionRunMode(3)       # at a crossing: straight on
setTRordRunMode(2)              # at a T: right
setLeftOrStraightRunMode(3)     # at a branch to the left: straight on
setRightOrStraightRunMode(3)    # at a branch to the right: straight on
patrolling(1)

while True:
    print(intersectionDetecting())
    delay(500)
