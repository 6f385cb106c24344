# Würfel
# Schütteln würfelt: Öffne die Sensoren und tippe auf «Schütteln».
from microbit import *
import random

display.show('?')

while True:
    if accelerometer.was_gesture('shake'):
        for roll in range(8):             # der Würfel rollt
            display.show(random.randint(1, 6))
            sleep(80)
        number = random.randint(1, 6)     # und bleibt liegen
        display.show(number)
        print('Gewürfelt:', number)
    sleep(50)
