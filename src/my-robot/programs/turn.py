# My robot 2: turning
# Each press of button A turns to the left for 2 seconds.
from microbit import *
from mbrobot import *

display.show(Image.ARROW_W)

while True:
    if button_a.was_pressed():
        delay(1000)           # take your finger away
        setSpeed(50)
        left()
        delay(2000)
        stop()
    delay(20)
