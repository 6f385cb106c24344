# Se parquer
# Tâche : parque-toi en marche arrière sans rien toucher.
# La ligne noire montre où t'arrêter et tourner. irM donne 0 sur un sol foncé.
from mbrobot_plusV2 import *

setSpeed(40)

forward()
while irM.read_digital() == 1:
    delay(5)
stop()
# Le robot est maintenant à côté de la place. Comment y entre-t-il en arrière ?
