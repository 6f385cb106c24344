# Lichterring
# An Pin 2 hängt ein Ring mit 24 Lichtern:
# Ein Regenbogen dreht sich, während der Roboter im Kreis fährt.
from mbrobot import *
from mbled import *

# drei Farben, dazwischen je acht Schritte
for pos in range(8):
    percent = pos * 100 / 8
    set_led(pos, *lerp_RGB(60, 0, 0, 0, 60, 0, percent))         # von Rot zu Grün
    set_led(pos + 8, *lerp_RGB(0, 60, 0, 0, 0, 60, percent))     # von Grün zu Blau
    set_led(pos + 16, *lerp_RGB(0, 0, 60, 60, 0, 0, percent))    # von Blau zu Rot

setSpeed(40)
leftArc(0.2)
for step in range(96):      # 24 Schritte sind eine Umdrehung
    shift_by(1)
    delay(80)
stop()
clear()
