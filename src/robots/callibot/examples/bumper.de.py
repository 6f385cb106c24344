# Anstossen und ausweichen
# Der Roboter fährt, bis er anstösst.
# Dann weicht er zurück, dreht sich weg und fährt weiter.
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
    if tsLeftValue():       # links angestossen: nach rechts
        setLEDLeft(1)
        back_off(right)
    elif tsRightValue():    # rechts angestossen: nach links
        setLEDRight(1)
        back_off(left)
    elif tsValue():         # gerade in die Wand gefahren
        setLED(1)
        back_off(right)
    delay(20)
