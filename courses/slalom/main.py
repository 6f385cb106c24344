# Slalom
# A half circle around each post: once to the right, once to the left.
from mbrobot import *

HALF_CIRCLE = 3825      # milliseconds for 180 degrees with setSpeed(50)

def half_circle(arc):
    arc(0.2)            # rightArc or leftArc, radius in metres
    delay(HALF_CIRCLE)
    stop()
    delay(300)          # each half circle begins standing still

setSpeed(50)

for i in range(2):
    half_circle(rightArc)
    half_circle(leftArc)
fillRGB(0, 80, 0)       # done!
