# Croisement et trous
# Si les deux capteurs extérieurs voient du foncé : croisement, tout droit. Un seul : c'est un angle.
# Dans un trou, tous voient du clair. Le robot roule alors tout droit jusqu'à ce que la ligne revienne.
from mbrobot_plusV2 import *

TO_WHEELS = 360         # millisecondes des capteurs extérieurs aux roues avec setSpeed(40)

def is_dark(sensor):
    return sensor.read_digital() == 0

def turn_corner(direction):
    """Roule jusqu'à ce que les roues soient sur l'angle, puis tourne jusqu'à la ligne suivante."""
    forward()
    delay(TO_WHEELS)
    direction()         # gauche ou droite
    delay(250)          # quitter l'ancienne ligne
    while not is_dark(irM):
        delay(5)

def outer():
    """Ce que voient les capteurs extérieurs, et encore peu après : le robot n'est jamais tout droit."""
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
        forward()       # le croisement
    elif corner_left:
        turn_corner(left)
    elif corner_right:
        turn_corner(right)
    elif is_dark(irL1) and not is_dark(irR1):
        leftArc(0.1)
    elif is_dark(irR1) and not is_dark(irL1):
        rightArc(0.1)
    else:
        forward()       # sur la ligne ou dans un trou
    delay(10)
