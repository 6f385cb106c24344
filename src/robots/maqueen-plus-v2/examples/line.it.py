# Seguire una linea
# Il sensore centrale deve restare sulla linea nera:
# 0 vuol dire scuro, 1 chiaro.
from mbrobot_plusV2 import *

setSpeed(40)

while True:
    if irL1.read_digital() == 0:        # la linea è a sinistra
        leftArc(0.06)
    elif irR1.read_digital() == 0:      # la linea è a destra
        rightArc(0.06)
    elif irM.read_digital() == 0:       # la linea è al centro
        forward()
    delay(10)
