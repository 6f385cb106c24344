# Le carré
# Tâche : parcours un carré de 40 cm de côté et reviens au départ.
# Combien de temps dure un côté, combien un coin ? Essaie et mesure.
from mbrobot import *

setSpeed(50)

forward()
delay(1000)             # millisecondes
stop()
delay(200)
left()
delay(300)
stop()
# Comment le robot fait-il cela quatre fois ? Conseil : for i in range(4):
