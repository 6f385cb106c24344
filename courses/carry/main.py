# Carry the block
# The claw hangs on servo port S1: 30 degrees is open, 90 degrees is closed.
from mbrobot import *

OPEN = 30
CLOSED = 90
QUARTER_TURN = 363      # milliseconds for 90 degrees at setSpeed(50)

def turn(direction):
    direction()         # left or right
    delay(QUARTER_TURN)
    stop()
    delay(300)

def drive_to_line():
    forward()
    while irLeft.read_digital() == 1 and irRight.read_digital() == 1:
        delay(5)
    stop()
    delay(300)

setServo("S1", OPEN)
delay(500)

forward()               # up to the block, until it lies between the jaws
while getDistance() > 4:
    delay(10)
stop()
setServo("S1", CLOSED)
delay(600)

forward()               # with the block in the claw
delay(1500)
stop()
delay(300)
turn(left)
drive_to_line()
forward()               # over the line, into the field
delay(450)
stop()

setServo("S1", OPEN)
delay(600)
backward()              # the block stays
delay(800)
stop()
fillRGB(0, 80, 0)       # done!
