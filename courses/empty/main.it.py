# Evitare gli ostacoli
# Il sensore a ultrasuoni misura la distanza dritto davanti, in centimetri.
from mbrobot import *

setSpeed(40)
setLED(1)

while True:
    if getDistance() < 15:
        stop()
        setAlarm(1)
        backward()          # un po' indietro
        delay(400)
        setAlarm(0)
        left()              # poi girare a sinistra
        delay(450)
    else:
        forward()
    delay(20)
