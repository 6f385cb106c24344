# Follow the leader: along the line, but not too close.
from mbrobot import *

NEAR = 12               # centimetres
FAR = 25

setSpeed(40)

while True:
    distance = getDistance()
    left_bright = irLeft.read_digital()
    right_bright = irRight.read_digital()
    if distance < NEAR:
        stop()
    elif not left_bright and right_bright:
        leftArc(0.1)
    elif left_bright and not right_bright:
        rightArc(0.1)
    elif not left_bright:
        setSpeed(45 if distance > FAR else 30)
        forward()
    delay(10)
