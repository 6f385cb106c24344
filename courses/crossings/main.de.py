# Kreuzung und Lücken
# Sehen beide äusseren Sensoren dunkel, ist es eine Kreuzung: geradeaus. Sieht nur einer dunkel, ist es eine Ecke.
# In einer Lücke sehen alle hell. Dann fährt der Roboter gerade weiter, bis die Linie wieder da ist.
from mbrobot_plusV2 import *

TO_WHEELS = 360         # Millisekunden von den äusseren Sensoren bis zu den Rädern mit setSpeed(40)

def is_dark(sensor):
    return sensor.read_digital() == 0

def turn_corner(direction):
    """Fährt, bis die Räder auf der Ecke sind, und dreht dann, bis der mittlere Sensor die nächste Linie sieht."""
    forward()
    delay(TO_WHEELS)
    direction()         # left oder right
    delay(250)          # von der alten Linie weg
    while not is_dark(irM):
        delay(5)

def outer():
    """Was die äusseren Sensoren sehen. Kurz danach nochmals: Der Roboter steht nie ganz gerade."""
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
        forward()       # die Kreuzung
    elif corner_left:
        turn_corner(left)
    elif corner_right:
        turn_corner(right)
    elif is_dark(irL1) and not is_dark(irR1):
        leftArc(0.1)
    elif is_dark(irR1) and not is_dark(irL1):
        rightArc(0.1)
    else:
        forward()       # auf der Linie oder in einer Lücke
    delay(10)
