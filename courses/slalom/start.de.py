# Slalom
# Auftrag: Fahr um die Pfosten herum ins Ziel, ohne sie zu berühren.
# rightArc(0.2) fährt einen Bogen nach rechts mit 20 cm Radius. Wie lange dauert ein Halbkreis?
from mbrobot import *

setSpeed(50)

rightArc(0.2)
delay(2000)             # Millisekunden: noch zu wenig
stop()
# Und wie geht es um den nächsten Pfosten?
