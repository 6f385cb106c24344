# Parcourir un carré
# Quatre fois : tout droit, puis un quart de tour à gauche.
from mbrobot import *

SIDE = 1500             # millisecondes pour un côté
QUARTER_TURN = 371      # millisecondes pour 90 degrés. Essaie d'autres nombres !

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
