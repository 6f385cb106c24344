# Steered by infrared
# The remote control sends pulses of light. A long pause is a 1, a short one a 0: together they are the number of the key.
from mbrobot import *
from microbit import pin16
from machine import time_pulse_us

UP = 10
DOWN = 8
LEFT = 4
RIGHT = 6
HELD = 100              # the key before is still held
NOTHING = 101

def receive():
    """Reads what the remote control sends; waits 130 milliseconds at most."""
    begin = time_pulse_us(pin16, 0, 130000)
    while 0 < begin < 8000:                             # not the beginning
        begin = time_pulse_us(pin16, 0, 130000)
    if begin < 0:
        return NOTHING
    if time_pulse_us(pin16, 1, 10000) < 4000:
        return HELD
    code = 0
    for bit in range(32):
        if time_pulse_us(pin16, 1, 10000) > 1000:
            code |= 1 << bit
    return code >> 16 & 255

pin16.set_pull(pin16.NO_PULL)
while True:
    key = receive()
    if key == UP:
        forward()
    elif key == DOWN:
        backward()
    elif key == LEFT:
        left()
    elif key == RIGHT:
        right()
    elif key == NOTHING:
        stop()
