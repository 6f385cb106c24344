# Seguire una linea
# I due sensori al centro vedono la linea:
# il robot va dove è scuro.
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
    # Dove tutti e due vedono chiaro, il robot continua come prima:
    # così ritrova la linea.
    delay(10)
