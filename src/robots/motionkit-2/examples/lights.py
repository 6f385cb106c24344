# Lights
# The robot has two red lights in front and coloured ones below,
# which all have the same colour.
from calliope_mini import *
from callimk import *

colors = [(80, 0, 0), (80, 50, 0), (0, 80, 0), (0, 60, 80), (0, 0, 80), (60, 0, 80)]

display.show(Image.HAPPY)

for red, green, blue in colors:
    rgbLED(red, green, blue)
    delay(500)

for part in range(0, 81, 4):    # red becomes blue
    rgbLED(80 - part, 0, part)
    setLEDLeft(part % 8 == 0)
    setLEDRight(part % 8 == 4)
    delay(150)

rgbLED(0, 0, 0)     # all off
setLED(0)
