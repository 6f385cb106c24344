# Lights
# The robot has two red lights in front and four coloured ones below.
from microbit import *
from mbrobot import *

colors = [(80, 0, 0), (80, 50, 0), (0, 80, 0), (0, 60, 80), (0, 0, 80), (60, 0, 80)]

display.show(Image.HAPPY)

for color in colors:
    red, green, blue = color
    fillRGB(red, green, blue)       # all four alike
    delay(500)

clearRGB()

for turn in range(3):
    for position in range(4):       # one light runs in a circle
        clearRGB()
        setRGB(position, 0, 80, 40)
        setLED(position % 2, 1 - position % 2)
        delay(200)

setLED(0)
clearRGB()
beep()
