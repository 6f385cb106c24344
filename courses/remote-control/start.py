# Task: drive to the target by remote control, past the wall.
# The remote control is a device of its own: choose its card above, and you see its program.
from mbrobot import *
import radio

radio.on()
radio.config(channel=7)

# A short twitch: the robot is ready.
forward()
delay(200)
stop()

while True:
    order = radio.receive()
    if order == "forward":
        forward()
    # What else shall the robot obey?
    delay(20)
