# Ago della bussola
# L'ago indica il nord. Apri i sensori e gira la bussola.
from microbit import *

needles = Image.ALL_CLOCKS         # 12 lancette, in senso orario

while True:
    heading = compass.heading()    # 0 è il nord, 90 l'est
    number = (360 - heading + 15) // 30 % 12
    display.show(needles[number])
    print('Direzione:', heading)
    sleep(200)
