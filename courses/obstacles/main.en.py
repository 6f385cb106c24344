# Avoid obstacles
# The ultrasonic sensor measures the distance straight ahead, in centimetres.
# It looks like the beam of a torch: what stands beside the beam stays unseen.
# So before the robot drives on, it also looks a little to the left and to the right.
from mbrobot import *

NEAR = 22               # centimetres: closer than this it does not go
LOOK = 130              # milliseconds of turning for a look to the side
STEP = 500              # milliseconds of driving between two looks

def turn(direction, milliseconds):
    direction()         # left or right
    delay(milliseconds)
    stop()
    delay(40)           # stand still, then measure

def look():
    """Distances to the left, ahead and to the right."""
    turn(left, LOOK)
    on_the_left = getDistance()
    turn(right, LOOK)
    ahead = getDistance()
    turn(right, LOOK)
    on_the_right = getDistance()
    turn(left, LOOK)
    return on_the_left, ahead, on_the_right

setSpeed(40)

while True:
    distances = look()
    if min(distances) > NEAR:
        setLED(0)
        forward()
        delay(STEP)
        stop()
    else:
        setLED(1)
        direction = left if distances[0] > distances[2] else right
        while min(distances) <= NEAR:   # always the same way round, or it would dither in a corner
            turn(direction, 2 * LOOK)
            distances = look()
