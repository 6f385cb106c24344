# Ring of lights
# On pin 2 hangs a ring of 24 lights:
# a rainbow turns while the robot drives in a circle.
from mbrobot import *
from mbled import *

# three colours with eight steps from each to the next
for pos in range(8):
    percent = pos * 100 / 8
    set_led(pos, *lerp_RGB(60, 0, 0, 0, 60, 0, percent))         # from red to green
    set_led(pos + 8, *lerp_RGB(0, 60, 0, 0, 0, 60, percent))     # from green to blue
    set_led(pos + 16, *lerp_RGB(0, 0, 60, 60, 0, 0, percent))    # from blue to red

setSpeed(40)
leftArc(0.2)
for step in range(96):      # 24 steps are one turn
    shift_by(1)
    delay(80)
stop()
clear()
