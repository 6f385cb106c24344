# Misurare la luce
# Più è chiaro, più LED sono accesi. Apri i sensori e cambia la luminosità.
from microbit import *

while True:
    light = display.read_light_level()     # 0 è buio, 255 è il più chiaro
    dots = light * 25 // 255
    for place in range(25):
        x = place % 5
        y = 4 - place // 5                 # prima la fila in basso
        if place < dots:
            display.set_pixel(x, y, 9)
        else:
            display.set_pixel(x, y, 0)
    print('Luce:', light)
    sleep(200)
