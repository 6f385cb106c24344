# Ein Servo am Anschluss P1
# Daran hängt ein Greifer: 30 heisst offen, 90 heisst zu.
# Etwas anderes wählst du unter «Gerät».
from mbrobot_plusV2 import *

OPEN = 30
CLOSED = 90

for turn in range(3):
    setServo("P1", OPEN)
    delay(1000)
    setServo("P1", CLOSED)
    delay(1000)

for angle in range(CLOSED, OPEN, -5):   # langsam öffnen
    setServo("P1", angle)
    delay(100)
