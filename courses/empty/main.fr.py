# Éviter les obstacles
# Le capteur à ultrasons mesure la distance droit devant, en centimètres.
from mbrobot import *

setSpeed(40)
setLED(1)

while True:
    if getDistance() < 15:
        stop()
        setAlarm(1)
        backward()          # un peu en arrière
        delay(400)
        setAlarm(0)
        left()              # puis tourner à gauche
        delay(450)
    else:
        forward()
    delay(20)
