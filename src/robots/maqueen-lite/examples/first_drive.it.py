# Primo viaggio
# Un quadrato e un cerchio. Cambia i numeri e guarda che cosa succede!
from mbrobot import *

setSpeed(50)
setLED(1)

for side in range(4):
    forward()
    delay(1200)
    left()
    delay(363)          # tanto dura un quarto di giro
    stop()
    delay(200)

setLED(0)
fillRGB(0, 60, 0)
rightArc(0.15)          # un cerchio con raggio di 15 cm
delay(6250)
stop()
clearRGB()
