# Kompassnadel
# Die Nadel zeigt nach Norden. Öffne die Sensoren und dreh den Kompass.
from microbit import *

needles = Image.ALL_CLOCKS         # 12 Zeiger, im Uhrzeigersinn

while True:
    heading = compass.heading()    # 0 ist Norden, 90 ist Osten
    number = (360 - heading + 15) // 30 % 12
    display.show(needles[number])
    print('Richtung:', heading)
    sleep(200)
