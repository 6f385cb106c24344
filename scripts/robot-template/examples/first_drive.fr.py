# Premier trajet
# Un petit bout de chemin et une rotation. Change les nombres et regarde ce qui se passe !
from microbit import sleep
from new_robot import *

setLED(1)
forward()
sleep(1000)
left()
sleep(400)
stop()
setLED(0)
print("clair" if isLight() else "foncé")
