# Seguire una linea
# Due sensori guardano il pavimento: 1 vuol dire chiaro, 0 scuro.
# Metti il robot su una linea nera, per esempio nel percorso
# «Linea chiusa».
from callibot import *

setSpeed(20)

while True:
    left_bright = irLeftValue()
    right_bright = irRightValue()
    if left_bright == 0 and right_bright == 0:
        forward()           # tutti e due sulla linea
    elif left_bright == 0:
        leftArc(0.1)        # la linea è a sinistra
    elif right_bright == 0:
        rightArc(0.1)       # la linea è a destra
    delay(10)
