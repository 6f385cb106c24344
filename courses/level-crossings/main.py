# Two level crossings
# As long as something is in the way, the robot stands: a barrier, a train, the buffer at the end.
from mbrobot import *

NEAR = 14               # centimetres

def is_dark(sensor):
    return sensor.read_digital() == 0

setSpeed(40)
forward()
while True:
    if getDistance() < NEAR:
        stop()
        setLED(1)
        while getDistance() < NEAR:
            delay(50)
        setLED(0)
        forward()
    if is_dark(irLeft) and is_dark(irRight):
        forward()
    elif is_dark(irLeft):
        leftArc(0.3)
    elif is_dark(irRight):
        rightArc(0.3)
    delay(5)            # beside the line the arc goes on
