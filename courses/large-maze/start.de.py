# Labyrinth mit der linken Hand
# Auftrag: Finde den Weg zur schwarzen Linie im Ziel.
# Die Zellen sind 25 cm breit. Wer immer der linken Wand folgt, kommt ans Ziel.
from mbrobot import *

QUARTER_TURN = 372      # Millisekunden für 90 Grad mit setSpeed(50)
CELL = 1420             # Millisekunden von einer Zelle zur nächsten

def turn(direction):
    direction()         # left oder right
    delay(QUARTER_TURN)
    stop()
    delay(200)          # ruhig stehen, dann erst messen

def drive_to_next_cell():
    forward()
    delay(CELL)
    stop()
    delay(200)

setSpeed(50)

turn(left)              # Ist links eine Wand?
print(getDistance(), "cm")
# Wann fährst du, wann drehst du weiter? Und wann bist du am Ziel?
