# Suivre une ligne
# Deux capteurs regardent le sol : 1 veut dire clair, 0 foncé.
# Place le robot sur une ligne noire, par exemple dans le parcours
# « Ligne fermée ».
from callibot import *

setSpeed(20)

while True:
    left_bright = irLeftValue()
    right_bright = irRightValue()
    if left_bright == 0 and right_bright == 0:
        forward()           # tous les deux sur la ligne
    elif left_bright == 0:
        leftArc(0.1)        # la ligne est à gauche
    elif right_bright == 0:
        rightArc(0.1)       # la ligne est à droite
    delay(10)
