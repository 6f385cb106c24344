# Carry the block
# Task: take the block with the claw and bring it into the target field.
# The claw is on the servo port S1: 30 degrees is open, 90 degrees is closed.
from mbrobot import *

OPEN = 30
CLOSED = 90

setServo("S1", OPEN)
delay(500)

forward()               # until the block is between the jaws
while getDistance() > 4:
    delay(10)
stop()
setServo("S1", CLOSED)
delay(600)
# You have the block. How does it get into the field?
