# Drive a square
# Four times: straight on, then a quarter turn to the left.
from mbrobot import *

SIDE = 1500             # milliseconds for one side
QUARTER_TURN = 371      # milliseconds for 90 degrees. Try other numbers!

setSpeed(50)

for side in range(4):
    forward()
    delay(SIDE)
    stop()
    delay(200)
    left()
    delay(QUARTER_TURN)
    stop()
    delay(200)
