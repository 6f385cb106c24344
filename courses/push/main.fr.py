# Pousser le bloc
# Quand les capteurs de ligne voient la ligne noire, le bloc devant le robot est déjà dans la zone.
from mbrobot import *

setSpeed(50)

forward()
while irLeft.read_digital() == 1 and irRight.read_digital() == 1:
    delay(10)
stop()
delay(300)

backward()              # le bloc reste où il est
delay(1000)
stop()
fillRGB(0, 80, 0)       # réussi !
