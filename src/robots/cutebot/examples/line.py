# Follow a line
# The robot steers to the side on which it sees black.
from microbit import *
from cutebot import *

FAST = 30
SLOW = 0                # below 15 the wheels stand still anyway

set_motors_speed(FAST, FAST)

while True:
    on_left = has_left_track()
    on_right = has_right_track()
    if on_left and on_right:
        set_motors_speed(FAST, FAST)
    elif on_left:
        set_motors_speed(SLOW, FAST)
    elif on_right:
        set_motors_speed(FAST, SLOW)
    # Where both see white, the robot goes on as before:
    # so it finds the line again.
    sleep(5)
