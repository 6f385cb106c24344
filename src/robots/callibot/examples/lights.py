# Lights
# The robot has two red lights in front and four coloured ones below.
# callibot has no command for the coloured ones:
# the program sends the bytes itself.
from calliope_mini import *
from callibot import *


def color(light, red, green, blue):
    # light 1 front left, 2 rear left, 3 rear right, 4 front right
    # red, green, blue: 0 to 16 each
    i2c.write(0x22, bytes([3, light, red, green, blue]))


colors = [(16, 0, 0), (16, 8, 0), (0, 16, 0), (0, 10, 16), (0, 0, 16), (10, 0, 16)]

display.show(Image.HAPPY)

for red, green, blue in colors:
    for light in range(1, 5):
        color(light, red, green, blue)
    delay(500)

for turn in range(12):      # one light runs in a circle
    for light in range(1, 5):
        color(light, 0, 0, 0)
    color(turn % 4 + 1, 0, 16, 8)
    if turn % 2 == 0:
        setLEDLeft(1)       # turns the right one off, too
    else:
        setLEDRight(1)
    delay(200)

i2c.write(0x22, bytes([1]))  # all off
