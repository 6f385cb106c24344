# Keep your distance
# The robot drives until the wall is 10 cm away, and remembers how long it took.
# Backwards it takes the same time.
from microbit import running_time
from mbrobot import *

setSpeed(50)

start = running_time()
forward()
while getDistance() > 10:
    delay(10)
stop()
way = running_time() - start

beep()
print("Driving time:", way, "ms")
delay(500)

backward()
delay(way)
stop()
