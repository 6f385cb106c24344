# Éviter les obstacles
# Tâche : va aux deux arrivées sans rien toucher.
# Le capteur à ultrasons mesure la distance devant en centimètres : getDistance().
# Conseil : devant un mur, regarde à gauche et à droite. Où y a-t-il plus de place ?
from mbrobot import *

setSpeed(50)

while True:
    if getDistance() < 22:
        stop()
        # Et maintenant ? Complète le programme.
    else:
        forward()
    delay(20)
