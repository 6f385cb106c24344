# Labyrinth mit Stossfänger
# Der Stossfänger meldet, wenn der Roboter eine Wand berührt. Dann fährt er zurück und versucht es links.
# Ist dort gleich eine Wand, nimmt er die andere Seite. Das Ziel ist eine schwarze Linie.
from calliopemini import running_time
from callibot import *

QUARTER_TURN = 357      # Millisekunden für 90 Grad mit setSpeed(20)
SHORT = 1500            # Millisekunden: Kommt eine Wand so bald, ist der Weg zu

def turn(direction):
    direction()         # left oder right
    delay(QUARTER_TURN)
    stop()
    delay(200)

def is_touching():
    return tsValue() or tsLeftValue() or tsRightValue()

def drive():
    """Fährt bis zur nächsten Wand. Gibt die Millisekunden der Fahrt zurück, am Ziel 0."""
    start = running_time()
    forward()
    while True:
        is_dark = irLeftValue() == 0 and irRightValue() == 0
        if is_touching():   # solange etwas drückt, gelten die Werte der Liniensensoren nicht
            way = running_time() - start
            backward()
            delay(250)
            stop()
            delay(200)
            return way
        if is_dark:
            stop()
            return 0
        delay(10)

setSpeed(20)
way = drive()

while way > 0:
    turn(left)
    way = drive()
    if 0 < way < SHORT:
        turn(left)      # zweimal ein Viertel: auf die andere Seite
        turn(left)
        way = drive()

setLED(1)               # geschafft!
