# Compass needle
# The needle points north. Open the sensors and turn the compass.
from microbit import *

needles = Image.ALL_CLOCKS         # 12 hands, clockwise

while True:
    heading = compass.heading()    # 0 is north, 90 is east
    number = (360 - heading + 15) // 30 % 12
    display.show(needles[number])
    print('Heading:', heading)
    sleep(200)
