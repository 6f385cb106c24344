# A servo at port P1
# A claw hangs on it: 30 is open, 90 is closed.
# Under “Device” you choose something else.
from mbrobot_plusV2 import *

OPEN = 30
CLOSED = 90

for turn in range(3):
    setServo("P1", OPEN)
    delay(1000)
    setServo("P1", CLOSED)
    delay(1000)

for angle in range(CLOSED, OPEN, -5):   # open slowly
    setServo("P1", angle)
    delay(100)
