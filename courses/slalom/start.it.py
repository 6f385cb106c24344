# Slalom
# Compito: gira attorno ai paletti fino all'arrivo senza toccarli.
# rightArc(0.2) percorre un arco a destra con raggio di 20 cm. Quanto dura un semicerchio?
from mbrobot import *

setSpeed(50)

rightArc(0.2)
delay(2000)             # millisecondi: non basta ancora
stop()
# E come si gira attorno al prossimo paletto?
