# Ligne avec angles
# Trois capteurs à l'avant gardent le robot sur la ligne ; les deux extérieurs, plus en arrière, voient un angle.
# Ils donnent tous 1 sur un sol clair et 0 sur un sol foncé.
from mbrobot_plusV2 import *

TO_WHEELS = 370         # millisecondes des capteurs extérieurs aux roues avec setSpeed(40)

def is_dark(sensor):
    return sensor.read_digital() == 0

def turn_corner(direction):
    """Roule jusqu'à ce que les roues soient sur l'angle, puis tourne jusqu'à la ligne suivante."""
    forward()
    delay(TO_WHEELS)
    direction()         # gauche ou droite
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
