# Klotz schieben
# Auftrag: Schiebe den Klotz ganz in das Zielfeld.
# Die schwarze Linie zeigt dir, wann es genug ist: irLeft.read_digital() ist dann 0.
from mbrobot import *

setSpeed(50)

forward()
delay(2000)
stop()
# Wie fährt der Roboter genau bis zur Linie?
