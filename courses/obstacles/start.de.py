# Hindernissen ausweichen
# Auftrag: Besuche beide Ziele, ohne etwas zu berühren.
# Der Ultraschall misst den Abstand nach vorne in Zentimetern: getDistance().
# Tipp: Schau dich vor einer Wand nach links und nach rechts um. Wo ist mehr Platz?
from mbrobot import *

setSpeed(50)

while True:
    if getDistance() < 22:
        stop()
        # Was nun? Ergänze das Programm.
    else:
        forward()
    delay(20)
