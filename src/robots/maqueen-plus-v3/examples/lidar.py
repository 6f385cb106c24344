# The lidar sees the way
# It measures in 64 directions at once, in 8 columns and 8 rows.
# Row 6 looks down: on free ground it sees the floor, 30 cm away.
from mbrobot_plusV3 import *

delay(3000)                         # the lidar needs 3 seconds to start
setSpeed(50)

while True:
    setLED(2)                       # green
    forward()
    while min(getDistanceRow(6)) > 24:
        delay(20)

    row = getDistanceRow(3)         # straight ahead, from left to right
    if row[0] > row[7]:             # turns to the side with more room
        setLEDs(3, 0)               # yellow on the left
        left()
    else:
        setLEDs(0, 3)
        right()
    while min(getDistanceRow(6)) < 29:
        delay(20)
    delay(150)                      # and a little further, past the edge
