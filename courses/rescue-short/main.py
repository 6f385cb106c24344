# Rescue line, short
# In a gap no sensor sees the line: then straight on. The colour sensor sees the red end.
from mbrobot_plusV2 import *
import colour

def is_dark(sensor):
    return sensor.read_digital() == 0

def is_at_end():
    return colour.name() == "red"

setSpeed(40)
while not is_at_end():
    if is_dark(irL1) and not is_dark(irR1):
        left()
    elif is_dark(irR1) and not is_dark(irL1):
        right()
    else:
        forward()       # on the line or in a gap
    delay(10)
delay(600)              # until the robot stands on the last tile
stop()
fillRGB(80, 0, 0)
delay(6000)             # five seconds, then the end counts
