# Dodge the guard
# The guard stands in the gate. Whoever touches its field lures it away: then the gate is free.
from mbrobot import *

NEAR = 16               # centimetres: so close the guard may come
QUARTER_TURN = 353      # milliseconds for 90 degrees with setSpeed(50)
EIGHTH_TURN = 202       # milliseconds for 45 degrees: starting takes a while, too

def drive(milliseconds):
    forward()
    delay(milliseconds)
    stop()
    delay(200)

def turn(direction, milliseconds):
    direction()         # left or right
    delay(milliseconds)
    stop()
    delay(200)

setSpeed(50)

turn(right, QUARTER_TURN)
drive(1500)             # onto its field
turn(left, QUARTER_TURN)
turn(left, EIGHTH_TURN)

setLED(1)
while getDistance() > NEAR:     # it is coming
    delay(20)
setLED(0)

turn(left, EIGHTH_TURN)         # away, past it
drive(2750)
turn(right, QUARTER_TURN)
drive(4900)
fillRGB(0, 80, 0)       # done!
