# Klotz tragen
# Auftrag: Fass den Klotz mit dem Greifer und bring ihn ins Zielfeld.
# Der Greifer hängt am Servo-Anschluss S1: 30 Grad ist offen, 90 Grad ist geschlossen.
from mbrobot import *

OPEN = 30
CLOSED = 90

setServo("S1", OPEN)
delay(500)

forward()               # bis der Klotz zwischen den Backen liegt
while getDistance() > 4:
    delay(10)
stop()
setServo("S1", CLOSED)
delay(600)
# Der Klotz ist gefasst. Wie kommt er ins Feld?
