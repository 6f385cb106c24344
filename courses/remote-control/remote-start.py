# The remote control sends an order when button A is pressed.
from microbit import *
import radio

radio.on()
radio.config(channel=7)

while True:
    if button_a.was_pressed():
        radio.send("forward")
    # How does the robot stop, and how does it turn?
    sleep(50)
