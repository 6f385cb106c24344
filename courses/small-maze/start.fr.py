# À travers le labyrinthe
# Tâche : roule dans le couloir jusqu'à la ligne noire de l'arrivée.
# Le capteur à ultrasons ne mesure que devant. Devant un mur, le robot doit regarder autour de lui.
from mbrobot import *

QUARTER_TURN = 372      # millisecondes pour 90 degrés avec setSpeed(50)

setSpeed(50)
forward()
while getDistance() > 6:
    delay(10)
stop()
delay(200)
left()
delay(QUARTER_TURN)
stop()
# Un virage est fait. Comment en faire un programme pour tout le labyrinthe ?
