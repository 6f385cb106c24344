# Evitare gli ostacoli
# Compito: va' a tutti e due gli arrivi senza toccare niente.
# Il sensore a ultrasuoni misura la distanza davanti in centimetri: getDistance().
# Consiglio: davanti a un muro guarda a sinistra e a destra. Dove c'è più posto?
from mbrobot import *

setSpeed(50)

while True:
    if getDistance() < 22:
        stop()
        # E adesso? Completa il programma.
    else:
        forward()
    delay(20)
