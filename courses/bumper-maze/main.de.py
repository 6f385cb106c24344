# Labyrinth mit Stossfänger
# Der Roboter lenkt immer ein wenig nach rechts, bis er eine Wand berührt.
# Dann fährt er zurück und dreht sich etwas nach links.
# So tastet er sich der Wand rechts entlang, um jede Ecke. Das Ziel ist eine schwarze Linie.
from callibot import *

RADIUS = 0.15           # Meter: so eng lenkt er nach rechts
BACK = 250              # Millisekunden von der Wand weg
AWAY = 250              # Millisekunden: so weit dreht er sich von der Wand weg

def is_touching():
    return tsValue() or tsLeftValue() or tsRightValue()

def is_dark():
    return irLeftValue() == 0 and irRightValue() == 0

def at_finish():
    """Das Ziel ist dunkel. Der gedrückte Stossfänger meldet auch dunkel: darum anhalten und nochmals schauen."""
    if not is_dark():
        return False
    stop()
    delay(100)
    return is_dark() and not is_touching()

setSpeed(20)

while not at_finish():
    rightArc(RADIUS)
    if is_touching():
        backward()
        delay(BACK)
        left()
        delay(AWAY)

stop()
setLED(1)               # geschafft!
