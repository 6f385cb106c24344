# Task: follow the leader into the target without touching it.
# The leader has a program of its own: choose its card above.
from mbrobot import *

setSpeed(30)
forward()
while getDistance() > 12:
    delay(10)
stop()
# The leader goes on. What now?
