# Avoid obstacles
# Task: visit both targets without touching anything.
# The ultrasonic sensor measures the distance ahead in centimetres: getDistance().
# Hint: in front of a wall, look to the left and to the right. Where is more room?
from mbrobot import *

setSpeed(50)

while True:
    if getDistance() < 22:
        stop()
        # What now? Complete the program.
    else:
        forward()
    delay(20)
