# Cuore e testo scorrevole
# 25 LED: immagini pronte, testo scorrevole, disegni tuoi.
from microbit import *

display.show(Image.HEART)     # un'immagine pronta
sleep(1000)                   # aspetta 1000 millisecondi
display.scroll('Ciao!')      # il testo scorre

# Un'immagine tua: 0 è spento, 9 è il più luminoso.
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
