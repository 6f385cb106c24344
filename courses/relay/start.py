# Task: the first runner hands over by radio, the second one runs into the target.
# The second runner is a device of its own: choose its card above.
from mbrobot import *
import radio

radio.on()
radio.config(channel=12)

setSpeed(50)
forward()
delay(1000)
stop()
# Where is the line? And how does the second runner learn that it may go?
