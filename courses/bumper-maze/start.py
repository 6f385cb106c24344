# Maze with a bumper
# Task: feel your way along the corridor with the bumper, up to the black line.
# tsValue() is 1 while both halves of the bumper are pressed, tsLeftValue() and tsRightValue() with one of them.
from callibot import *

QUARTER_TURN = 357      # milliseconds for 90 degrees with setSpeed(20)

def is_touching():
    return tsValue() or tsLeftValue() or tsRightValue()

setSpeed(20)
forward()
while not is_touching():
    delay(10)
backward()
delay(250)
stop()
# You are at the first wall. Where now?
