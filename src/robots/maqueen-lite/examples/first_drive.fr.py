# Premier trajet
# Un carré et un cercle. Change les nombres et regarde ce qui se passe !
from mbrobot import *

setSpeed(50)
setLED(1)

for side in range(4):
    forward()
    delay(1200)
    left()
    delay(363)          # c'est le temps d'un quart de tour
    stop()
    delay(200)

setLED(0)
fillRGB(0, 60, 0)
rightArc(0.15)          # un cercle d'un rayon de 15 cm
delay(6250)
stop()
clearRGB()
