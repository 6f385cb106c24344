# Virages et S
# Tâche : suis la ligne par tous les virages et reviens au départ.
# Ce programme perd la ligne dans les virages serrés. Pourquoi ? Améliore-le.
from mbrobot import *

setSpeed(50)

while True:
    left_bright = irLeft.read_digital()
    right_bright = irRight.read_digital()
    if not left_bright and right_bright:
        leftArc(0.2)        # la ligne est à gauche
    elif left_bright and not right_bright:
        rightArc(0.2)       # la ligne est à droite
    else:
        forward()
    delay(10)
