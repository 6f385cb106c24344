# Klotz tragen
# Der Greifer hängt am Servo-Anschluss S1: 30 Grad ist offen, 90 Grad ist geschlossen.
from mbrobot import *

OPEN = 30
CLOSED = 90
QUARTER_TURN = 363      # Millisekunden für 90 Grad mit setSpeed(50)

def turn(direction):
    direction()         # left oder right
    delay(QUARTER_TURN)
    stop()
    delay(300)

def drive_to_line():
    forward()
    while irLeft.read_digital() == 1 and irRight.read_digital() == 1:
        delay(5)
    stop()
    delay(300)

setServo("S1", OPEN)
delay(500)

forward()               # bis der Klotz zwischen den Backen liegt
while getDistance() > 4:
    delay(10)
stop()
setServo("S1", CLOSED)
delay(600)

forward()               # mit dem Klotz im Greifer
delay(1500)
stop()
delay(300)
turn(left)
drive_to_line()
forward()               # über die Linie, ins Feld
delay(450)
stop()

setServo("S1", OPEN)
delay(600)
backward()              # der Klotz bleibt liegen
delay(800)
stop()
fillRGB(0, 80, 0)       # geschafft!
