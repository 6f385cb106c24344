# Allée des pics
# Tâche : roule dans l'allée jusqu'à l'arrivée sans toucher les pics.
# Le capteur à ultrasons voit les pics comme des murs.
from mbrobot_plusV2 import *

setSpeed(40)

forward()
while getDistance() > 9:
    delay(10)
stop()
# Maintenant à gauche. Combien de temps dure un quart de tour ?
