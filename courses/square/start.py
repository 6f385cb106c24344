# The square
# Task: drive a square with sides of 40 cm and come back to the start.
# How long does a side take, how long a corner? Try it out and measure.
from mbrobot import *

setSpeed(50)

forward()
delay(1000)             # milliseconds
stop()
delay(200)
left()
delay(300)
stop()
# How does the robot do this four times? Hint: for i in range(4):
