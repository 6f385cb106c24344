# Linie mit Ecken
# Auftrag: Folge der Linie über alle Ecken und komm zurück zum Start.
# Die Sensoren irL2, irL1, irM, irR1 und irR2 melden 1 auf hellem und 0 auf dunklem Boden.
# Tipp: irL2 und irR2 liegen aussen. Sie sehen nur bei einer Ecke dunkel.
from mbrobot_plusV2 import *

setSpeed(40)

while True:
    if irL1.read_digital() == 0 and irR1.read_digital() == 1:
        leftArc(0.1)        # die Linie liegt links
    elif irR1.read_digital() == 0 and irL1.read_digital() == 1:
        rightArc(0.1)       # die Linie liegt rechts
    else:
        forward()
    # Und an den Ecken? Ergänze das Programm.
    delay(10)
