# Le carré
# Quatre fois la même chose : un côté, un quart de tour.
from mbrobot import *

SIDE = 2200             # millisecondes pour 40 cm avec setSpeed(50)
QUARTER_TURN = 372      # millisecondes pour 90 degrés

setSpeed(50)

for i in range(4):
    forward()
    delay(SIDE)
    stop()
    delay(200)          # s'arrêter avant de tourner
    left()
    delay(QUARTER_TURN)
    stop()
    delay(200)
