# The square
# Four times the same: drive a side, make a quarter turn.
from mbrobot import *

SIDE = 2200             # milliseconds for 40 cm with setSpeed(50)
QUARTER_TURN = 372      # milliseconds for 90 degrees

setSpeed(50)

for i in range(4):
    forward()
    delay(SIDE)
    stop()
    delay(200)          # stand still before you turn
    left()
    delay(QUARTER_TURN)
    stop()
    delay(200)
