# Le grand tour
# Tâche : passe par les points de contrôle 1 à 5, puis va à l'arrivée.
# leftArc(0.2) et rightArc(0.2) roulent des arcs de 20 cm de rayon. Combien de temps dure un quart de cercle ?
from callibot import *

setSpeed(20)

forward()
delay(2600)
leftArc(0.2)
delay(1000)
stop()
# Et ensuite ?
