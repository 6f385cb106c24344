# Suivre une ligne
# Les deux capteurs du milieu voient la ligne :
# le robot se dirige là où c'est foncé.
from mbrobot_plus import *

setSpeed(40)
forward()

while True:
    left_light = irL1.read_digital()
    right_light = irR1.read_digital()
    if left_light and not right_light:
        rightArc(0.1)
    elif right_light and not left_light:
        leftArc(0.1)
    elif not left_light:
        forward()
    # Là où tous deux voient un sol clair, le robot continue comme avant :
    # ainsi il retrouve la ligne.
    delay(10)
