# Lane of spikes
# The ultrasonic sensor sees spikes like walls. In the middle of the lane its end is 9 cm ahead of the sensor.
from mbrobot_plusV2 import *

NEAR = 9                # centimetres
QUARTER_TURN = 590      # milliseconds for 90 degrees with setSpeed(40)

def drive_to_end():
    forward()
    while getDistance() > NEAR:
        delay(10)
    stop()
    delay(200)

def turn(direction):
    direction()         # left or right
    delay(QUARTER_TURN)
    stop()
    delay(200)

setSpeed(40)

for direction in (left, left, right, right):
    drive_to_end()
    turn(direction)
drive_to_end()
