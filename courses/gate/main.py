# The sliding gate
# At the black line the robot waits until the gate is closed and then opens again.
# This gives it the longest time to drive through.
from mbrobot import *

FREE = 50               # centimetres: the gate is never so far away

def distance():
    """The smallest of three measurements: when an echo is lost, getDistance() gives 255."""
    return min(getDistance(), getDistance(), getDistance())

setSpeed(60)

forward()
while irLeft.read_digital() == 1:
    delay(5)
stop()

setLED(1)
while distance() > FREE:        # open, but for how long?
    delay(20)
while distance() < FREE:        # closed
    delay(20)
setLED(0)

forward()
delay(1900)
stop()
fillRGB(0, 80, 0)       # done!
