# Hindernissen ausweichen
# Der Ultraschall misst den Abstand nach vorne in Zentimetern.
from mbrobot import *

setSpeed(40)
setLED(1)

while True:
    if getDistance() < 15:
        stop()
        setAlarm(1)
        backward()          # ein Stück zurück
        delay(400)
        setAlarm(0)
        left()              # dann nach links drehen
        delay(450)
    else:
        forward()
    delay(20)
