# The second robot drives up to the bar.
from mbrobot import *
import radio

radio.on()
radio.config(channel=20)

setSpeed(40)
forward()
while getDistance() > 5:
    delay(10)
stop()
