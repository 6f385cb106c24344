# Ein Quadrat fahren
# Vier Mal: geradeaus, dann eine Vierteldrehung nach links.
from mbrobot import *

SIDE_TIME = 1500            # Millisekunden für eine Seite
TURN_TIME = 300             # Millisekunden für 90 Grad. Stimmt die Drehung? Probiere andere Werte!

setSpeed(50)

for side in range(4):
    forward()
    delay(SIDE_TIME)
    left()
    delay(TURN_TIME)

stop()
