# Through the maze
# Task: drive along the corridor to the black line in the target.
# The ultrasonic sensor measures ahead only. In front of a wall, the robot has to look around.
from mbrobot import *

QUARTER_TURN = 372      # milliseconds for 90 degrees with setSpeed(50)

setSpeed(50)
forward()
while getDistance() > 6:
    delay(10)
stop()
delay(200)
left()
delay(QUARTER_TURN)
stop()
# One bend is done. How does it become a program for the whole maze?
