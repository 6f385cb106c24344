# Through the maze
# The robot measures straight ahead only. In front of a wall it first looks to the left.
# If there is a wall too, the way goes on to the right. The finish is a black line.
from mbrobot import *

QUARTER_TURN = 372      # milliseconds for 90 degrees at setSpeed(50)
NEAR = 6                # centimetres: so close it drives up to a wall

def turn(direction):
    direction()         # left or right
    delay(QUARTER_TURN)
    stop()
    delay(200)          # stand still, then measure

def at_finish():
    return irLeft.read_digital() == 0 and irRight.read_digital() == 0

setSpeed(50)

while not at_finish():
    if getDistance() > NEAR:
        forward()
    else:
        stop()
        delay(200)
        turn(left)
        if getDistance() < 20:
            turn(right)
            turn(right)
    delay(10)

stop()
fillRGB(0, 80, 0)       # done!
