# Crossing and gaps
# Task: follow the line over the crossing and the gaps, back to the start.
# Think first: which of the five sensors see dark at a corner, on the crossing, in a gap?
from mbrobot_plusV2 import *

def is_dark(sensor):
    return sensor.read_digital() == 0

setSpeed(40)

while True:
    if is_dark(irL1) and not is_dark(irR1):
        leftArc(0.1)
    elif is_dark(irR1) and not is_dark(irL1):
        rightArc(0.1)
    else:
        forward()
    # irL2 and irR2 are the outer ones. What do you do when they see dark?
    delay(10)
