# Thermometer
# A face shows how warm it is. Button A shows the number.
from microbit import *

while True:
    degrees = temperature()
    if button_a.was_pressed():
        display.scroll(degrees)
    elif degrees < 10:
        display.show(Image.SAD)
    elif degrees < 28:
        display.show(Image.HAPPY)
    else:
        display.show(Image.SURPRISED)
    sleep(100)
