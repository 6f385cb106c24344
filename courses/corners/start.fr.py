# Ligne avec angles
# Tâche : suis la ligne par tous les angles et reviens au départ.
# Les capteurs irL2, irL1, irM, irR1 et irR2 donnent 1 sur un sol clair et 0 sur un sol foncé.
# Conseil : irL2 et irR2 sont les extérieurs. Ils ne voient du foncé que dans un angle.
from mbrobot_plusV2 import *

setSpeed(40)

while True:
    if irL1.read_digital() == 0 and irR1.read_digital() == 1:
        leftArc(0.1)        # la ligne est à gauche
    elif irR1.read_digital() == 0 and irL1.read_digital() == 1:
        rightArc(0.1)       # la ligne est à droite
    else:
        forward()
    # Et aux angles ? Complète le programme.
    delay(10)
