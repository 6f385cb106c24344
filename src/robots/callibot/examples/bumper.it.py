# Urtare e girare
# Il robot va finché urta qualcosa.
# Poi indietreggia, gira e riparte.
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
    if tsLeftValue():       # urto a sinistra: girare a destra
        setLEDLeft(1)
        back_off(right)
    elif tsRightValue():    # urto a destra: girare a sinistra
        setLEDRight(1)
        back_off(left)
    elif tsValue():         # dritto contro il muro
        setLED(1)
        back_off(right)
    delay(20)
