# Kurven und S
# Auftrag: Folge der Linie durch alle Kurven und komm zurück zum Start.
# Dieses Programm verliert die Linie in engen Kurven. Warum? Verbessere es.
from mbrobot import *

setSpeed(50)

while True:
    left_bright = irLeft.read_digital()
    right_bright = irRight.read_digital()
    if not left_bright and right_bright:
        leftArc(0.2)        # die Linie liegt links
    elif left_bright and not right_bright:
        rightArc(0.2)       # die Linie liegt rechts
    else:
        forward()
    delay(10)
