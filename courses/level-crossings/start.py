# Two level crossings
# Task: drive to the target, and touch neither a barrier nor a train.
# The robot follows the line, but it never looks ahead. getDistance() says how far away the next thing is.
from mbrobot import *

def is_dark(sensor):
    return sensor.read_digital() == 0

setSpeed(40)
forward()
while True:
    if is_dark(irLeft) and is_dark(irRight):
        forward()
    elif is_dark(irLeft):
        leftArc(0.3)
    elif is_dark(irRight):
        rightArc(0.3)
    delay(5)            # beside the line the arc goes on
