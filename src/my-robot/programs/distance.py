# My robot 3: distance
# Each press of button A shows what the ultrasonic sensor measures, in cm.
from microbit import *
from mbrobot import *

display.show(Image.ARROW_N)

while True:
    if button_a.was_pressed():
        total = 0
        for reading in range(10):
            total += getDistance()
            delay(60)
        print(total / 10)
        display.scroll(total / 10)
        display.show(Image.ARROW_N)
    delay(20)
