# Clear the ring
# Task: push all three blocks out of the circle, into the fields at the edge.
# Hint: turn on the spot until you see a block, drive, and stop on the black line.
from mbrobot import *

def on_line():
    return irLeft.read_digital() == 0 or irRight.read_digital() == 0

setSpeed(45)

while getDistance() > 28:   # no block in sight yet
    left()
    delay(35)
    stop()
    delay(40)               # stand still before you measure

forward()
while not on_line():
    delay(5)
stop()
# A block is at the line. How does it go on?
