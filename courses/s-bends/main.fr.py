# Virages et S
# Les virages sont plus serrés que n'importe quel arc. Le robot tourne donc sur place dès qu'il quitte la ligne.
# Quand plus aucun capteur ne voit la ligne, il continue à tourner du côté où elle était en dernier.
from mbrobot import *

setSpeed(35)
last = left             # le côté où la ligne était en dernier

while True:
    left_dark = irLeft.read_digital() == 0
    right_dark = irRight.read_digital() == 0
    if left_dark and right_dark:
        forward()
    elif left_dark:
        left()
        last = left
    elif right_dark:
        right()
        last = right
    else:
        last()          # gauche ou droite
    delay(5)
