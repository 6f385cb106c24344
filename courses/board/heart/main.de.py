# Herz und Laufschrift
# 25 Lichter: fertige Bilder, laufender Text, eigene Muster.
from microbit import *

display.show(Image.HEART)     # ein fertiges Bild
sleep(1000)                   # 1000 Millisekunden warten
display.scroll('Hallo!')      # der Text läuft durch

# Ein eigenes Bild: 0 ist dunkel, 9 ist ganz hell.
boat = Image('00900:'
             '00990:'
             '00950:'
             '99999:'
             '09990')

while True:
    display.show(boat)
    sleep(500)
    display.show(Image.HEART)
    sleep(500)
