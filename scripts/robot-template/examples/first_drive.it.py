# Primo viaggio
# Un pezzetto di strada e una rotazione. Cambia i numeri e guarda che cosa succede!
from microbit import sleep
from new_robot import *

setLED(1)
forward()
sleep(1000)
left()
sleep(400)
stop()
setLED(0)
print("chiaro" if isLight() else "scuro")
