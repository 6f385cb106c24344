# Heart and scrolling text
# 25 lights: ready images, scrolling text, patterns of your own.
from microbit import *

display.show(Image.HEART)     # a ready image
sleep(1000)                   # wait for 1000 milliseconds
display.scroll('Hello!')      # the text scrolls by

# An image of your own: 0 is dark, 9 is brightest.
boat = Image('00900:'
             '00990:'
             '00950:'
             '99999:'
             '09990')

while True:
    display.show(boat)
    sleep(500)
    display.show(Image.HEART)
    sleep(500)
