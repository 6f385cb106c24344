# La porta scorrevole
# Compito: passa per la porta fino all'arrivo senza toccare la porta scorrevole.
# Consiglio: alla linea d'arresto misura con getDistance() se la via è libera.
from mbrobot import *

setSpeed(60)

forward()
while irLeft.read_digital() == 1:
    delay(5)
stop()
# Sei alla linea d'arresto. Che cosa aspetti?
while True:
    print(getDistance(), "cm")
    delay(200)
