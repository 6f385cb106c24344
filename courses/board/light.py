# Light meter
# The brighter it is, the more lights are on. Open the sensors and change the light level.
from microbit import *

while True:
    light = display.read_light_level()     # 0 is dark, 255 is brightest
    dots = light * 25 // 255
    for place in range(25):
        x = place % 5
        y = 4 - place // 5                 # the lowest row first
        if place < dots:
            display.set_pixel(x, y, 9)
        else:
            display.set_pixel(x, y, 0)
    print('Light:', light)
    sleep(200)
