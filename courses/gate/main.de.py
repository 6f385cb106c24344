# Das Schiebetor
# An der schwarzen Linie wartet der Roboter, bis das Tor zu ist und sich dann wieder öffnet.
# So bleibt ihm die längste Zeit, um hindurchzufahren.
from mbrobot import *

FREE = 50               # Zentimeter: so weit weg ist das Tor nie

def distance():
    """Die kleinste von drei Messungen: geht ein Echo verloren, gibt getDistance() 255."""
    return min(getDistance(), getDistance(), getDistance())

setSpeed(60)

forward()
while irLeft.read_digital() == 1:
    delay(5)
stop()

setLED(1)
while distance() > FREE:        # offen, aber wie lange noch?
    delay(20)
while distance() < FREE:        # zu
    delay(20)
setLED(0)

forward()
delay(2900)
stop()
fillRGB(0, 80, 0)       # geschafft!
