# Seguire la linea
# Due sensori guardano il pavimento sotto il robot. Danno 1 sul chiaro e 0 sullo scuro.
# Sulla linea tutti e due i sensori vedono scuro.
from mbrobot import *

setSpeed(40)

while True:
    left_bright = irLeft.read_digital()
    right_bright = irRight.read_digital()
    if not left_bright and not right_bright:
        forward()           # al centro della linea
    elif not left_bright:
        leftArc(0.06)       # la linea è a sinistra
    elif not right_bright:
        rightArc(0.06)      # la linea è a destra
    # altrimenti: linea persa, avanti come prima
    delay(10)
