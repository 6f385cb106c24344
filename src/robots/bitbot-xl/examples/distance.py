# Never touch a wall
# Something is near: turn away on the spot, then drive on.
from mbbitbot import *

NEAR = 25               # centimetres

setSpeed(20)

while True:
    if getDistance() < NEAR:
        fill(60, 0, 0)
        right()
        sleep(350)
    else:
        fill(0, 30, 0)
        forward()
    sleep(50)
