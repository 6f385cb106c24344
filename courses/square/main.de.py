# Das Quadrat
# Viermal dasselbe: eine Seite fahren, um einen Viertel drehen.
from mbrobot import *

SIDE = 2200             # Millisekunden für 40 cm mit setSpeed(50)
QUARTER_TURN = 372      # Millisekunden für 90 Grad

setSpeed(50)

for i in range(4):
    forward()
    delay(SIDE)
    stop()
    delay(200)          # ruhig stehen, dann erst drehen
    left()
    delay(QUARTER_TURN)
    stop()
    delay(200)
