# Line with corners
# Three sensors in front keep the robot on the line; the two outer ones, farther back, see a corner.
# All of them give 1 on light and 0 on dark ground.
from mbrobot_plusV2 import *

TO_WHEELS = 370         # milliseconds from the outer sensors to the wheels at setSpeed(40)

def is_dark(sensor):
    return sensor.read_digital() == 0

def turn_corner(direction):
    """Drives until the wheels are on the corner, then turns until the middle sensor sees the next line."""
    forward()
    delay(TO_WHEELS)
    direction()         # left or right
    while not is_dark(irM):
        delay(5)

setSpeed(40)

while True:
    if is_dark(irL2):
        turn_corner(left)
    elif is_dark(irR2):
        turn_corner(right)
    elif is_dark(irL1) and not is_dark(irR1):
        leftArc(0.1)
    elif is_dark(irR1) and not is_dark(irL1):
        rightArc(0.1)
    else:
        forward()
    delay(10)
