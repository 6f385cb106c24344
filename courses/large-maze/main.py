# Maze with the left hand
# The left-hand rule: in each cell look to the left first, then straight ahead, then to the right.
# Whoever keeps to the wall on the left gets everywhere. The target is a black line.
from microbit import running_time
from mbrobot import *

QUARTER_TURN = 372      # milliseconds for 90 degrees with setSpeed(50)
CELL = 1420             # milliseconds from one cell to the next
MIDDLE = 7              # centimetres to the wall ahead when the robot is in the middle of the cell

def turn(direction):
    direction()         # left or right
    delay(QUARTER_TURN)
    stop()
    delay(200)          # stand still before you measure

def at_finish():
    return irLeft.read_digital() == 0 and irRight.read_digital() == 0

def drive_to_next_cell():
    """Drives one cell. With a wall ahead, its distance is more exact than the time."""
    start = running_time()
    forward()
    while not at_finish():
        distance = getDistance()
        if distance <= MIDDLE:
            break
        if running_time() - start > CELL and distance > 2 * MIDDLE:
            break
        delay(5)
    stop()
    delay(200)

setSpeed(50)

while not at_finish():
    turn(left)
    while getDistance() < 2 * MIDDLE:   # there is a wall
        turn(right)
    drive_to_next_cell()

fillRGB(0, 80, 0)       # done!
