# The tunnel
# Task: drive through the tunnel to the target.
# In the tunnel there is no line. How does the robot notice that it is in there?
from mbrobot import *
from microbit import display

def is_dark(sensor):
    return sensor.read_digital() == 0

def follow_line():
    if is_dark(irLeft) and is_dark(irRight):
        forward()
    elif is_dark(irLeft):
        leftArc(0.2)
    elif is_dark(irRight):
        rightArc(0.2)
    delay(5)            # beside the line the arc goes on

forward()
while getDistance() > 30:
    follow_line()
    print(display.read_light_level())
stop()
# You are in the tunnel. Which way does it go on?
