# Rundreise
# Auftrag: Fahr durch die Kontrollpunkte 1 bis 5 und dann ins Ziel.
# leftArc(0.2) und rightArc(0.2) fahren Bögen von 20 cm Radius. Wie lange dauert ein Viertelkreis?
from callibot import *

setSpeed(20)

forward()
delay(2600)
leftArc(0.2)
delay(1000)
stop()
# Und weiter?
