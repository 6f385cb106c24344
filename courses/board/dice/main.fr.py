# Dé
# Secoue pour lancer le dé : ouvre les capteurs et touche « Secouer ».
from microbit import *
import random

display.show('?')

while True:
    if accelerometer.was_gesture('shake'):
        for roll in range(8):             # le dé roule
            display.show(random.randint(1, 6))
            sleep(80)
        number = random.randint(1, 6)     # et s'arrête
        display.show(number)
        print('Résultat :', number)
    sleep(50)
