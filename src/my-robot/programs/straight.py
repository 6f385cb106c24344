# My robot 1: straight ahead
# Each press of button A drives once:
# 1 slowly for 4 seconds, 2 as usual for 2 seconds, 3 fast for 1 second.
# Button B goes back to the drive before.
from microbit import *
from mbrobot import *

DRIVES = [(20, 4000), (50, 2000), (100, 1000)]
number = 0

while True:
    display.show(number + 1)
    if button_b.was_pressed():
        number = (number - 1) % 3
    if button_a.was_pressed():
        speed, ms = DRIVES[number]
        delay(1000)           # take your finger away
        setSpeed(speed)
        forward()
        delay(ms)
        stop()
        number = (number + 1) % 3
    delay(20)
