# Vider le cercle
# Tâche : pousse les trois blocs hors du cercle, dans les zones du bord.
# Conseil : tourne sur place jusqu'à ce que tu voies un bloc, roule, et arrête-toi sur la ligne noire.
from mbrobot import *

def on_line():
    return irLeft.read_digital() == 0 or irRight.read_digital() == 0

setSpeed(45)

while getDistance() > 28:   # pas encore de bloc en vue
    left()
    delay(35)
    stop()
    delay(40)               # arrête-toi avant de mesurer

forward()
while not on_line():
    delay(5)
stop()
# Un bloc est à la ligne. Et ensuite ?
