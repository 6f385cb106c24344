# Cogner et se détourner
# Le robot roule jusqu'à ce qu'il cogne quelque chose.
# Puis il recule, se détourne et repart.
from callibot import *


def back_off(turn):
    backward()
    delay(600)
    turn()
    delay(350)
    setLED(0)
    forward()


setSpeed(40)
setLED(0)
forward()

while True:
    if tsLeftValue():       # cogné à gauche : tourner à droite
        setLEDLeft(1)
        back_off(right)
    elif tsRightValue():    # cogné à droite : tourner à gauche
        setLEDRight(1)
        back_off(left)
    elif tsValue():         # droit dans le mur
        setLED(1)
        back_off(right)
    delay(20)
