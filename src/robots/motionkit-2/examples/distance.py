# Do not bump
# The robot drives until something is nearer than 15 cm.
# Then it turns away.
# Button A stops it.
from calliope_mini import *
from callimk import *

setSpeed(30)

while not button_a.was_pressed():
    if getDistance() < 15:
        rgbLED(80, 0, 0)
        backward()
        delay(400)
        right()
        delay(600)
    else:
        rgbLED(0, 60, 0)
        forward()
    delay(50)

stop()
rgbLED(0, 0, 0)
