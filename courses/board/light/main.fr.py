# Mesurer la lumière
# Plus il fait clair, plus il y a de LED allumées. Ouvre les capteurs et change la luminosité.
from microbit import *

while True:
    light = display.read_light_level()     # 0 est sombre, 255 est le plus clair
    dots = light * 25 // 255
    for place in range(25):
        x = place % 5
        y = 4 - place // 5                 # la rangée du bas d'abord
        if place < dots:
            display.set_pixel(x, y, 9)
        else:
            display.set_pixel(x, y, 0)
    print('Lumière :', light)
    sleep(200)
