# Steered by infrared
# Task: steer the robot with the remote control through the gate to the target.
# receive() already reads the pulses of the remote control. Press each key and see its number below.
from mbrobot import *
from microbit import pin16
from machine import time_pulse_us

UP = 10
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

# A short twitch: the robot is ready.
forward()
delay(200)
stop()

pin16.set_pull(pin16.NO_PULL)
while True:
    key = receive()
    if key < HELD:
        print("key", key)
    if key == UP:
        forward()
    # What do the other keys do? And when does the robot stop?
