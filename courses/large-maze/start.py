# Maze with the left hand
# Task: find the way to the black line in the target.
# The cells are 25 cm wide. Whoever keeps to the wall on the left gets to the target.
from mbrobot import *

QUARTER_TURN = 372      # milliseconds for 90 degrees with setSpeed(50)
CELL = 1420             # milliseconds from one cell to the next

def turn(direction):
    direction()         # left or right
    delay(QUARTER_TURN)
    stop()
    delay(200)          # stand still before you measure

def drive_to_next_cell():
    forward()
    delay(CELL)
    stop()
    delay(200)

setSpeed(50)

turn(left)              # Is there a wall on the left?
print(getDistance(), "cm")
# When do you drive, when do you go on turning? And when have you arrived?
