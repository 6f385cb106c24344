# The robot does what it hears.
from mbrobot import *
import radio

radio.on()
radio.config(channel=7)
setSpeed(30)

while True:
    order = radio.receive()
    if order == "forward":
        forward()
    elif order == "left":
        left()
    elif order == "right":
        right()
    elif order == "stop":
        stop()
    delay(20)
