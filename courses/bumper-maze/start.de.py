# Labyrinth mit Stossfänger
# Auftrag: Taste dich mit dem Stossfänger durch den Gang bis zur schwarzen Linie.
# tsValue() ist 1, wenn beide Hälften des Stossfängers drücken, tsLeftValue() und tsRightValue() bei einer.
from callibot import *

QUARTER_TURN = 357      # Millisekunden für 90 Grad mit setSpeed(20)

def is_touching():
    return tsValue() or tsLeftValue() or tsRightValue()

setSpeed(20)
forward()
while not is_touching():
    delay(10)
backward()
delay(250)
stop()
# Du bist an der ersten Wand. Wohin jetzt?
