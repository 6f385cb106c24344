# Maze with a bumper
# The robot always steers a little to the right, until it touches a wall.
# Then it backs off and turns a little to the left.
# So it feels its way along the wall on its right, around each corner. The finish is a black line.
from callibot import *

RADIUS = 0.15           # metres: so tightly it steers to the right
BACK = 250              # milliseconds away from the wall
AWAY = 250              # milliseconds: so far it turns away from the wall

def is_touching():
    return tsValue() or tsLeftValue() or tsRightValue()

def is_dark():
    return irLeftValue() == 0 and irRightValue() == 0

def at_finish():
    """The finish is dark. With the bumper pressed all seems dark, too: so stop and look again."""
    if not is_dark():
        return False
    stop()
    delay(100)
    return is_dark() and not is_touching()

setSpeed(20)

while not at_finish():
    rightArc(RADIUS)
    if is_touching():
        backward()
        delay(BACK)
        left()
        delay(AWAY)

stop()
setLED(1)               # done!
