# Primo viaggio
# Un po' dritto, un cerchio, una rotazione.
# Cambia i numeri e guarda che cosa succede!
from callibot import *

setSpeed(50)
setLED(1)
forward()
delay(1000)             # 1000 millisecondi sono un secondo

rightArc(0.15)          # un cerchio con raggio di 15 cm
delay(4000)

left()                  # gira sul posto
delay(600)

stop()
setLED(0)
print("Distanza davanti:", round(getDistance()), "cm")
