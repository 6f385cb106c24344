# Pousser le bloc
# Tâche : pousse le bloc entièrement dans la zone d'arrivée.
# La ligne noire te dit quand ça suffit : irLeft.read_digital() donne alors 0.
from mbrobot import *

setSpeed(50)

forward()
delay(2000)
stop()
# Comment le robot roule-t-il exactement jusqu'à la ligne ?
