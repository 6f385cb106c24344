# Incrocio e interruzioni
# Se tutti e due i sensori esterni vedono scuro, è un incrocio: dritto. Se lo vede uno solo, è un angolo.
# In un'interruzione tutti vedono chiaro. Allora il robot va dritto finché la linea ritorna.
from mbrobot_plusV2 import *

TO_WHEELS = 360         # millisecondi dai sensori esterni alle ruote con setSpeed(40)

def is_dark(sensor):
    return sensor.read_digital() == 0

def turn_corner(direction):
    """Va finché le ruote sono sull'angolo, poi gira finché il sensore centrale vede la linea."""
    forward()
    delay(TO_WHEELS)
    direction()         # sinistra o destra
    delay(250)          # via dalla vecchia linea
    while not is_dark(irM):
        delay(5)

def outer():
    """Che cosa vedono i sensori esterni. E di nuovo poco dopo: il robot non è mai del tutto dritto."""
    seen_left, seen_right = is_dark(irL2), is_dark(irR2)
    if seen_left or seen_right:
        forward()
        for i in range(6):
            delay(10)
            seen_left = seen_left or is_dark(irL2)
            seen_right = seen_right or is_dark(irR2)
    return seen_left, seen_right

setSpeed(40)

while True:
    corner_left, corner_right = outer()
    if corner_left and corner_right:
        forward()       # l'incrocio
    elif corner_left:
        turn_corner(left)
    elif corner_right:
        turn_corner(right)
    elif is_dark(irL1) and not is_dark(irR1):
        leftArc(0.1)
    elif is_dark(irR1) and not is_dark(irL1):
        rightArc(0.1)
    else:
        forward()       # sulla linea o in un'interruzione
    delay(10)
