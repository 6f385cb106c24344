# Premier trajet
# Un peu tout droit, un cercle, une rotation.
# Change les nombres et regarde ce qui se passe !
from callibot import *

setSpeed(50)
setLED(1)
forward()
delay(1000)             # 1000 millisecondes font une seconde

rightArc(0.15)          # un cercle d'un rayon de 15 cm
delay(4000)

left()                  # tourne sur place
delay(600)

stop()
setLED(0)
print("Distance devant :", round(getDistance()), "cm")
