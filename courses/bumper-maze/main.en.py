# Maze with a bumper
# The bumper tells when the robot touches a wall. At each wall it backs off and tries the left.
# Is there a wall at once, it goes the other way. The finish is a black line.
from calliopemini import running_time
from callibot import *

QUARTER_TURN = 357      # milliseconds for 90 degrees at setSpeed(20)
SHORT = 1500            # milliseconds: a wall that comes so soon closes the way

def turn(direction):
    direction()         # left or right
    delay(QUARTER_TURN)
    stop()
    delay(200)

def is_touching():
    return tsValue() or tsLeftValue() or tsRightValue()

def drive():
    """Drives to the next wall. Gives the milliseconds it took, or 0 at the finish."""
    start = running_time()
    forward()
    while True:
        is_dark = irLeftValue() == 0 and irRightValue() == 0
        if is_touching():   # while the bumper is pressed, the line sensors' values mean nothing
            way = running_time() - start
            backward()
            delay(250)
            stop()
            delay(200)
            return way
        if is_dark:
            stop()
            return 0
        delay(10)

setSpeed(20)
way = drive()

while way > 0:
    turn(left)
    way = drive()
    if 0 < way < SHORT:
        turn(left)      # twice a quarter: the other way
        turn(left)
        way = drive()

setLED(1)               # done!
