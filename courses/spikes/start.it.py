# Vicolo delle punte
# Compito: percorri il vicolo fino all'arrivo senza toccare le punte.
# Il sensore a ultrasuoni vede le punte come muri.
from mbrobot_plusV2 import *

setSpeed(40)

forward()
while getDistance() > 9:
    delay(10)
stop()
# Adesso a sinistra. Quanto dura un quarto di giro?
