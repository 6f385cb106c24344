# Linea con angoli
# Tre sensori davanti tengono il robot sulla linea; i due esterni, più indietro, vedono un angolo.
# Danno tutti 1 sul chiaro e 0 sullo scuro.
from mbrobot_plusV2 import *

TO_WHEELS = 370         # millisecondi dai sensori esterni alle ruote con setSpeed(40)

def is_dark(sensor):
    return sensor.read_digital() == 0

def turn_corner(direction):
    """Va finché le ruote sono sull'angolo, poi gira finché il sensore centrale vede la linea."""
    forward()
    delay(TO_WHEELS)
    direction()         # sinistra o destra
    while not is_dark(irM):
        delay(5)

setSpeed(40)

while True:
    if is_dark(irL2):
        turn_corner(left)
    elif is_dark(irR2):
        turn_corner(right)
    elif is_dark(irL1) and not is_dark(irR1):
        leftArc(0.1)
    elif is_dark(irR1) and not is_dark(irL1):
        rightArc(0.1)
    else:
        forward()
    delay(10)
