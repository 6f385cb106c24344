# Linie mit Ecken
# Drei Sensoren vorn halten den Roboter auf der Linie; die zwei äusseren weiter hinten sehen eine Ecke.
# Alle melden 1 auf hellem und 0 auf dunklem Boden.
from mbrobot_plusV2 import *

TO_WHEELS = 370         # Millisekunden von den äusseren Sensoren bis zu den Rädern mit setSpeed(40)

def is_dark(sensor):
    return sensor.read_digital() == 0

def turn_corner(direction):
    """Fährt, bis die Räder auf der Ecke sind, und dreht dann, bis der mittlere Sensor die nächste Linie sieht."""
    forward()
    delay(TO_WHEELS)
    direction()         # left oder right
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
