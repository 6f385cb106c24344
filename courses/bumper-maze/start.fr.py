# Labyrinthe avec pare-chocs
# Tâche : avance à tâtons dans le couloir avec le pare-chocs, jusqu'à la ligne noire.
# tsValue() est 1 quand tout le pare-chocs est pressé, tsLeftValue() et tsRightValue() pour une moitié.
from callibot import *

QUARTER_TURN = 357      # millisecondes pour 90 degrés avec setSpeed(20)

def is_touching():
    return tsValue() or tsLeftValue() or tsRightValue()

setSpeed(20)
forward()
while not is_touching():
    delay(10)
backward()
delay(250)
stop()
# Tu es au premier mur. Et maintenant, où aller ?
