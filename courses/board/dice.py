# Dice
# Shake to roll: open the sensors and tap "Shake".
from microbit import *
import random

display.show('?')

while True:
    if accelerometer.was_gesture('shake'):
        for roll in range(8):             # the die rolls
            display.show(random.randint(1, 6))
            sleep(80)
        number = random.randint(1, 6)     # and comes to rest
        display.show(number)
        print('Rolled:', number)
    sleep(50)
