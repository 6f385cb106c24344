# Premier trajet
# En avant, un virage, en arrière. Change les nombres et regarde ce qui se passe !
from mbrobot_plusV2 import *

setSpeed(50)
setLED(1)

forward()
delay(2000)
leftArc(0.2)            # un arc d'un rayon de 20 cm
delay(4000)
setLED(0, 1)
right()                 # tourne sur place
delay(800)
backward()
delay(1000)
stop()

setLED(0)
beep()
