# Task: push the rival out of the ring, and stay inside yourself.
# The rival is a device of its own: choose its card above, and you see what it does.
from mbrobot import *

def at_edge():
    return irLeft.read_digital() == 0 or irRight.read_digital() == 0

setSpeed(40)
forward()
delay(300)
stop()
while True:
    if at_edge():
        backward()
        delay(500)
        stop()
    # How do you find the rival, and when do you push?
    delay(20)
