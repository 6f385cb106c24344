# The first runner drives to the line and hands over.
from mbrobot import *
import radio

radio.on()
radio.config(channel=12)

setSpeed(50)
forward()
while irLeft.read_digital() == 1 and irRight.read_digital() == 1:
    delay(10)
delay(200)              # into the field
stop()
radio.send("go")        # the baton
