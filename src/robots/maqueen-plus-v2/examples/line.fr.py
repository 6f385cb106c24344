# Suivre une ligne
# Le capteur du milieu doit rester sur la ligne noire :
# 0 veut dire foncé, 1 clair.
from mbrobot_plusV2 import *

setSpeed(40)

while True:
    if irL1.read_digital() == 0:        # la ligne est à gauche
        leftArc(0.06)
    elif irR1.read_digital() == 0:      # la ligne est à droite
        rightArc(0.06)
    elif irM.read_digital() == 0:       # la ligne est au milieu
        forward()
    delay(10)
