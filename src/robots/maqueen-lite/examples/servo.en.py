# A servo at port S1
# Under “Device” you choose what hangs on it.
# For the claw, 30 is open and 90 is closed.
from mbrobot import *

OPEN = 30
CLOSED = 90

for turn in range(3):
    setServo("S1", OPEN)
    delay(1000)
    setServo("S1", CLOSED)
    delay(1000)

for angle in range(CLOSED, OPEN, -5):   # open slowly
    setServo("S1", angle)
    delay(100)
