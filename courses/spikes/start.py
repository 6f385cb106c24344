# Lane of spikes
# Task: drive along the lane to the target without touching the spikes.
# The ultrasonic sensor sees spikes like walls.
from mbrobot_plusV2 import *

setSpeed(40)

forward()
while getDistance() > 9:
    delay(10)
stop()
# Now to the left. How long does a quarter turn take?
