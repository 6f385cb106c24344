# Task: push the bar into the field, both together.
# Alone it turns aside. The second robot is a device of its own: choose its card above.
from mbrobot import *
import radio

radio.on()
radio.config(channel=20)

setSpeed(40)
forward()
while getDistance() > 5:
    delay(10)
stop()
# Both stand at the bar. How do they start in the same moment?
