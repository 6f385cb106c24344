# Curve e una S
# Compito: segui la linea per tutte le curve e torna alla partenza.
# Questo programma perde la linea nelle curve strette. Perché? Miglioralo.
from mbrobot import *

setSpeed(50)

while True:
    left_bright = irLeft.read_digital()
    right_bright = irRight.read_digital()
    if not left_bright and right_bright:
        leftArc(0.2)        # la linea è a sinistra
    elif left_bright and not right_bright:
        rightArc(0.2)       # la linea è a destra
    else:
        forward()
    delay(10)
