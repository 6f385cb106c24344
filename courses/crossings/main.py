# Crossing and gaps
# If both outer sensors see dark, it is a crossing: straight on. If only one does, it is a corner.
# In a gap all see light. Then the robot drives straight on until the line is there again.
from mbrobot_plusV2 import *

TO_WHEELS = 360         # milliseconds from the outer sensors to the wheels with setSpeed(40)

def is_dark(sensor):
    return sensor.read_digital() == 0

def turn_corner(direction):
    """Drives until the wheels are on the corner, then turns until the middle sensor sees the next line."""
    forward()
    delay(TO_WHEELS)
    direction()         # left or right
    delay(250)          # away from the old line
    while not is_dark(irM):
        delay(5)

def outer():
    """What the outer sensors see. And again shortly after: the robot never stands quite straight."""
    seen_left, seen_right = is_dark(irL2), is_dark(irR2)
    if seen_left or seen_right:
        forward()
        for i in range(6):
            delay(10)
            seen_left = seen_left or is_dark(irL2)
            seen_right = seen_right or is_dark(irR2)
    return seen_left, seen_right

setSpeed(40)

while True:
    corner_left, corner_right = outer()
    if corner_left and corner_right:
        forward()       # the crossing
    elif corner_left:
        turn_corner(left)
    elif corner_right:
        turn_corner(right)
    elif is_dark(irL1) and not is_dark(irR1):
        leftArc(0.1)
    elif is_dark(irR1) and not is_dark(irL1):
        rightArc(0.1)
    else:
        forward()       # on the line or in a gap
    delay(10)
