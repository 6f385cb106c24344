# Linea con angoli
# Compito: segui la linea per tutti gli angoli e torna alla partenza.
# I sensori irL2, irL1, irM, irR1 e irR2 danno 1 sul chiaro e 0 sullo scuro.
# Consiglio: irL2 e irR2 sono quelli esterni. Vedono scuro solo a un angolo.
from mbrobot_plusV2 import *

setSpeed(40)

while True:
    if irL1.read_digital() == 0 and irR1.read_digital() == 1:
        leftArc(0.1)        # la linea è a sinistra
    elif irR1.read_digital() == 0 and irL1.read_digital() == 1:
        rightArc(0.1)       # la linea è a destra
    else:
        forward()
    # E agli angoli? Completa il programma.
    delay(10)
