# Follow a line
# Both sensors are on the line: straight on. One of them leaves it: steer back.
from mbbitbot import *

FAST = 200
SLOW = 60

while True:
    on_left = getLine(0)        # 1 on dark ground
    on_right = getLine(1)
    if on_left and not on_right:
        w(SLOW, 0, FAST, 0)
        set_led(5, 0, 0, 60)
    elif on_right and not on_left:
        w(FAST, 0, SLOW, 0)
        set_led(11, 0, 0, 60)
    elif on_left and on_right:
        w(FAST, 0, FAST, 0)
        fill(0, 0, 0)
    sleep(5)
