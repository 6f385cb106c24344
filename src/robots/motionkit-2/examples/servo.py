# A servo at port S1
# A claw hangs on it: 30 is open, 90 is closed.
# Under “Device” you choose something else.
from callimk import *

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
