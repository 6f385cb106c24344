# Sumo: look for the rival, then push.
from mbrobot import *

SEEN = 32               # centimetres

def at_edge():
    return irLeft.read_digital() == 0 or irRight.read_digital() == 0

def look_for_rival():
    """Turns until something is ahead."""
    setSpeed(30)
    left()
    while getDistance() > SEEN:
        delay(20)

def push():
    """Pushes until the edge is below, or the rival is gone."""
    setSpeed(100)
    forward()
    while not at_edge() and getDistance() < SEEN:
        delay(10)

def back_to_middle():
    setSpeed(60)
    backward()
    delay(700)

while True:
    look_for_rival()
    push()
    if at_edge():
        back_to_middle()
