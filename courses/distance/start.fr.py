# Garder la distance
# Tâche : roule jusqu'à 10 cm du mur et reviens en marche arrière au départ.
# getDistance() mesure la distance devant, en centimètres.
from mbrobot import *

setSpeed(50)
forward()
delay(1000)
print(getDistance(), "cm")
# Comment le robot continue-t-il tant que la distance est plus grande que 10 ? Conseil : while
stop()
