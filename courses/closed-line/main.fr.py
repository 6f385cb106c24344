# Suivre la ligne
# Deux capteurs regardent le sol sous le robot. Ils donnent 1 sur un sol clair et 0 sur un sol foncé.
# Sur la ligne, les deux capteurs voient du foncé.
from mbrobot import *

setSpeed(40)

while True:
    left_bright = irLeft.read_digital()
    right_bright = irRight.read_digital()
    if not left_bright and not right_bright:
        forward()           # au milieu de la ligne
    elif not left_bright:
        leftArc(0.06)       # la ligne est à gauche
    elif not right_bright:
        rightArc(0.06)      # la ligne est à droite
    # sinon : ligne perdue, continuer comme avant
    delay(10)
