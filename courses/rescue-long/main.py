# Rescue line, long
# Straight on in gaps and at crossings, around the obstacle, and five seconds of rest at the red end.
from mbrobot_plusV2 import *
import colour

NEAR = 9                # centimetres

def is_dark(sensor):
    return sensor.read_digital() == 0

def sees_line():
    return is_dark(irL1) or is_dark(irM) or is_dark(irR1)

def is_crossing():
    return is_dark(irL2) and is_dark(irR2)

def follow_line():
    if is_crossing():
        forward()
    elif is_dark(irL1) and not is_dark(irR1):
        left()
    elif is_dark(irR1) and not is_dark(irL1):
        right()
    else:
        forward()       # on the line or in a gap
    delay(10)

def drive_around():
    """To the right, in an arc around the obstacle and back to the line."""
    right()
    delay(500)
    leftArc(0.2)
    delay(1500)         # away from the line before the obstacle
    while not sees_line():
        delay(10)
    forward()           # over the line, then back into its direction
    delay(300)
    right()
    while not is_dark(irM):
        delay(5)

setSpeed(40)
while colour.name() != "red":
    if getDistance() < NEAR:
        drive_around()
    follow_line()
delay(600)              # until the robot stands on the last tile
stop()
fillRGB(80, 0, 0)
delay(6000)             # five seconds, then the end counts
