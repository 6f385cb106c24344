# Curve e una S
# Le curve sono più strette di qualsiasi arco. Perciò il robot gira sul posto appena lascia la linea.
# Quando nessun sensore vede più la linea, continua a girare dalla parte dov'era l'ultima volta.
from mbrobot import *

setSpeed(35)
last = left             # la parte dov'era la linea l'ultima volta

while True:
    left_dark = irLeft.read_digital() == 0
    right_dark = irRight.read_digital() == 0
    if left_dark and right_dark:
        forward()
    elif left_dark:
        left()
        last = left
    elif right_dark:
        right()
        last = right
    else:
        last()          # sinistra o destra
    delay(5)
