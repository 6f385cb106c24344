# Parcheggiare
# Compito: parcheggia a marcia indietro senza toccare niente.
# La linea nera mostra dove fermarti e girare. irM dà 0 sullo scuro.
from mbrobot_plusV2 import *

setSpeed(40)

forward()
while irM.read_digital() == 1:
    delay(5)
stop()
# Ora il robot è accanto al posto. Come ci entra all'indietro?
