# Ein Servo am Anschluss S1
# Daran hängt ein Greifer: 30 heisst offen, 90 heisst zu.
# Etwas anderes wählst du unter «Gerät».
from mbrobot import *

OPEN = 30
CLOSED = 90

for turn in range(3):
    setServo("S1", OPEN)
    delay(1000)
    setServo("S1", CLOSED)
    delay(1000)

for angle in range(CLOSED, OPEN, -5):   # langsam öffnen
    setServo("S1", angle)
    delay(100)
