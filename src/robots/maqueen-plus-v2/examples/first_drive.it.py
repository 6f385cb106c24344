# Primo viaggio
# Avanti, una curva, indietro. Cambia i numeri e guarda che cosa succede!
from mbrobot_plusV2 import *

setSpeed(50)
setLED(1)

forward()
delay(2000)
leftArc(0.2)            # un arco con raggio di 20 cm
delay(4000)
setLED(0, 1)
right()                 # gira sul posto
delay(800)
backward()
delay(1000)
stop()

setLED(0)
beep()
