# Lichtmesser
# Je heller es ist, desto mehr Lichter leuchten. Öffne die Sensoren und verändere die Lichtstärke.
from microbit import *

while True:
    light = display.read_light_level()     # 0 ist dunkel, 255 ganz hell
    dots = light * 25 // 255
    for place in range(25):
        x = place % 5
        y = 4 - place // 5                 # die unterste Reihe zuerst
        if place < dots:
            display.set_pixel(x, y, 9)
        else:
            display.set_pixel(x, y, 0)
    print('Licht:', light)
    sleep(200)
