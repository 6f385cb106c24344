# Rescue line, long
# Task: follow the line over all tiles to the red end and stop there for five seconds.
# Gaps are no problem any more. But an obstacle stands on the line, and there is a crossing.
from mbrobot_plusV2 import *
import colour

NEAR = 9                # centimetres

def is_dark(sensor):
    return sensor.read_digital() == 0

def follow_line():
    if is_dark(irL1) and not is_dark(irR1):
        left()
    elif is_dark(irR1) and not is_dark(irL1):
        right()
    else:
        forward()       # on the line or in a gap
    delay(10)

setSpeed(40)
while getDistance() > NEAR:
    follow_line()
stop()
print(getDistance(), "cm")
# How does the robot get around the obstacle and back to the line?
