# Avoid obstacles
# The ultrasonic sensor measures the distance straight ahead, in centimetres.
from mbrobot import *

setSpeed(40)
setLED(1)

while True:
    if getDistance() < 15:
        stop()
        setAlarm(1)
        backward()          # a little back
        delay(400)
        setAlarm(0)
        left()              # then turn to the left
        delay(450)
    else:
        forward()
    delay(20)
