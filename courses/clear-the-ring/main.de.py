# Ring leeren
# Der Roboter dreht an Ort, bis er einen Klotz sieht, und schiebt ihn über den schwarzen Kreis.
# Zeigt eine ganze Drehung keinen Klotz mehr, ist der Ring leer.
from mbrobot import *

FAR = 28                # Zentimeter: Was weiter weg ist, liegt ausserhalb
FULL_TURN = 60          # so viele kleine Drehungen sind mehr als eine Runde
TO_MIDDLE = 1600        # Millisekunden von der Linie zur Mitte

def on_line():
    return irLeft.read_digital() == 0 or irRight.read_digital() == 0

def look_around():
    """Dreht, bis ein Klotz zu sehen ist. False: Es ist keiner da."""
    for i in range(FULL_TURN):
        if getDistance() < FAR:
            return True
        left()
        delay(35)
        stop()
        delay(40)       # ruhig stehen, dann erst messen
    return False

def push_out():
    """Schiebt, was vorne liegt, über die Linie und kommt zur Mitte zurück."""
    forward()
    while not on_line():
        delay(5)
    delay(350)          # der Klotz liegt vor dem Roboter: noch etwas weiter
    backward()
    while not on_line():
        delay(5)
    while on_line():
        delay(5)
    delay(TO_MIDDLE)
    stop()

setSpeed(45)
count = 0
while look_around():
    left()              # der Strahl ist breit: bis zu seiner Mitte drehen
    delay(60)
    stop()
    push_out()
    count += 1
    print("hinausgeschoben:", count)

stop()
fillRGB(0, 80, 0)       # geschafft!
