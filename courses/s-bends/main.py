# Bends and an S
# The bends are tighter than any arc. So the robot turns on the spot as soon as it leaves the line.
# When no sensor sees the line any more, it goes on turning to the side where the line was last.
from mbrobot import *

setSpeed(35)
last = left             # the side on which the line was last

while True:
    left_dark = irLeft.read_digital() == 0
    right_dark = irRight.read_digital() == 0
    if left_dark and right_dark:
        forward()
    elif left_dark:
        left()
        last = left
    elif right_dark:
        right()
        last = right
    else:
        last()          # left or right
    delay(5)
