# Dado
# Scuoti per lanciare il dado: apri i sensori e tocca «Scuoti».
from microbit import *
import random

display.show('?')

while True:
    if accelerometer.was_gesture('shake'):
        for roll in range(8):             # il dado rotola
            display.show(random.randint(1, 6))
            sleep(80)
        number = random.randint(1, 6)     # e si ferma
        display.show(number)
        print('Risultato:', number)
    sleep(50)
