# Ein Quadrat fahren
# Viermal: geradeaus, dann eine Vierteldrehung nach links.
from mbrobot import *

SIDE = 1500             # Millisekunden für eine Seite
QUARTER_TURN = 371      # Millisekunden für 90 Grad. Probier andere Zahlen aus!

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
