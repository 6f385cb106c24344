# Incrocio e interruzioni
# Compito: segui la linea per l'incrocio e le interruzioni, e torna alla partenza.
# Prima rifletti: quali dei cinque sensori vedono scuro a un angolo, all'incrocio, in un'interruzione?
from mbrobot_plusV2 import *

def is_dark(sensor):
    return sensor.read_digital() == 0

setSpeed(40)

while True:
    if is_dark(irL1) and not is_dark(irR1):
        leftArc(0.1)
    elif is_dark(irR1) and not is_dark(irL1):
        rightArc(0.1)
    else:
        forward()
    # irL2 e irR2 sono quelli esterni. Che cosa fai quando vedono scuro?
    delay(10)
