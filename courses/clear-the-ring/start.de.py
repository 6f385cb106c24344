# Ring leeren
# Auftrag: Schiebe alle drei Klötze aus dem Kreis in die Felder am Rand.
# Tipp: Dreh an Ort, bis du einen Klotz siehst, fahr los und halt auf der schwarzen Linie.
from mbrobot import *

def on_line():
    return irLeft.read_digital() == 0 or irRight.read_digital() == 0

setSpeed(45)

while getDistance() > 28:   # noch ist kein Klotz zu sehen
    left()
    delay(35)
    stop()
    delay(40)               # ruhig stehen, dann erst messen

forward()
while not on_line():
    delay(5)
stop()
# Ein Klotz ist an der Linie. Wie geht es weiter?
