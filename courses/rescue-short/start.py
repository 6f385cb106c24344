# Rescue line, short
# Task: follow the line over all tiles to the red end and stop there for five seconds.
# The robot follows the line up to the first gap. The score sheet shows what earns points.
from mbrobot_plusV2 import *
import colour

def is_dark(sensor):
    return sensor.read_digital() == 0

setSpeed(40)
while is_dark(irL1) or is_dark(irM) or is_dark(irR1):
    if is_dark(irL1) and not is_dark(irR1):
        left()
    elif is_dark(irR1) and not is_dark(irL1):
        right()
    else:
        forward()
    delay(10)
stop()
print(colour.name())
# What does the robot do in the gap? And how does it notice the red end?
