# Clear the ring
# The robot turns on the spot until it sees a block, drives at it and pushes it over the black circle.
# When a full turn shows no block any more, the ring is empty.
from mbrobot import *

FAR = 28                # centimetres: farther away things are outside the ring
FULL_TURN = 60          # so many small turns make more than one round
TO_MIDDLE = 1600        # milliseconds from the line to the middle

def on_line():
    return irLeft.read_digital() == 0 or irRight.read_digital() == 0

def look_around():
    """Turns until it sees a block. False: there is none."""
    for i in range(FULL_TURN):
        if getDistance() < FAR:
            return True
        left()
        delay(35)
        stop()
        delay(40)       # stand still, then measure
    return False

def push_out():
    """Pushes what is ahead over the line and comes back to the middle."""
    forward()
    while not on_line():
        delay(5)
    delay(350)          # the block lies ahead of the robot: a little farther
    backward()
    while not on_line():
        delay(5)
    while on_line():
        delay(5)
    delay(TO_MIDDLE)
    stop()

setSpeed(45)
count = 0
while look_around():
    left()              # the beam is wide: turn to its middle
    delay(60)
    stop()
    push_out()
    count += 1
    print("pushed out:", count)

stop()
fillRGB(0, 80, 0)       # done!
