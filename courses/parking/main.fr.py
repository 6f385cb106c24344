# Se parquer
# Quand les capteurs voient la ligne noire, les roues sont juste à côté de la place.
from mbrobot_plusV2 import *

QUARTER_TURN = 590      # millisecondes pour 90 degrés avec setSpeed(40)
INTO_SPACE = 2300       # millisecondes en arrière jusque dans la place

setSpeed(40)

forward()
while irM.read_digital() == 1:
    delay(5)
stop()
delay(300)

left()                  # l'arrière est tourné vers la place
delay(QUARTER_TURN)
stop()
delay(300)

backward()
delay(INTO_SPACE)
stop()
setLED(1)
