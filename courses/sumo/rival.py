# The rival drives to and fro in the ring and turns at the edge.
from mbrobot import *

setSpeed(30)

while True:
    forward()
    while irLeft.read_digital() == 1 and irRight.read_digital() == 1:
        delay(10)
    backward()
    delay(900)
    left()
    delay(500)
