# Steered by infrared
# The remote control sends pulses of light. A long pause is a 1, a short one a 0: together they are the number of the key.
# The road helps: while a key is held, the robot stays on the line. At its end it stops.
from mbrobot import *
from microbit import pin16, running_time
from machine import time_pulse_us

UP = 10
DOWN = 8
LEFT = 4
RIGHT = 6
HELD = 100              # the key before is still held
NOTHING = 101

def receive():
    """Reads what the remote control sends now; waits 5 milliseconds at most."""
    if time_pulse_us(pin16, 0, 5000) < 2000:
        return NOTHING                                  # not the beginning
    if time_pulse_us(pin16, 1, 10000) < 4000:
        return HELD
    code = 0
    for bit in range(32):
        if time_pulse_us(pin16, 1, 10000) > 1000:
            code |= 1 << bit
    return code >> 16 & 255

def is_dark(sensor):
    return sensor.read_digital() == 0

def drive(on_line):
    """Forward, along a line if there is one. Says when it was last on it."""
    left_dark, right_dark = is_dark(irLeft), is_dark(irRight)
    if left_dark and not right_dark:
        left()
    elif right_dark and not left_dark:
        right()
    elif left_dark or running_time() - on_line < 300 or on_line == 0:
        forward()
    else:
        stop()          # the line has ended
    return running_time() if left_dark or right_dark else on_line

def turn(direction, pressed):
    """Turns up to the next line."""
    if running_time() - pressed > 300 and (is_dark(irLeft) or is_dark(irRight)):
        stop()
    else:
        direction()

pin16.set_pull(pin16.NO_PULL)
key = NOTHING
heard = 0
while True:
    signal = receive()
    if signal != NOTHING:
        heard = running_time()
    if signal != NOTHING and signal != HELD:
        key = signal
        pressed = heard
        on_line = 0
    if running_time() - heard > 200:
        key = NOTHING   # let go
    if key == UP:
        on_line = drive(on_line)
    elif key == DOWN:
        backward()
    elif key == LEFT:
        turn(left, pressed)
    elif key == RIGHT:
        turn(right, pressed)
    else:
        stop()
