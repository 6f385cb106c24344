# Sort by colour
# Task: carry the red blocks into the red zone and the blue blocks into the blue zone.
# The colour sensor looks ahead. The claw is on the servo port S1: 30 degrees is open, 90 degrees is closed.
from mbrobot import *
import colour

OPEN = 30
CLOSED = 90

setServo("S1", OPEN)
delay(500)

forward()               # until the first block is between the jaws
while getDistance() > 4:
    delay(10)
stop()
setServo("S1", CLOSED)
delay(600)
print(colour.name())
# Where does this block belong? And how does the robot come back to the line?
