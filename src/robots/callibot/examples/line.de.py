# Einer Linie folgen
# Zwei Sensoren schauen auf den Boden: 1 heisst hell, 0 heisst dunkel.
# Stell den Roboter auf eine schwarze Linie, zum Beispiel im Kurs
# «Geschlossene Linie».
from callibot import *

setSpeed(20)

while True:
    left_bright = irLeftValue()
    right_bright = irRightValue()
    if left_bright == 0 and right_bright == 0:
        forward()           # beide auf der Linie
    elif left_bright == 0:
        leftArc(0.1)        # die Linie ist links
    elif right_bright == 0:
        rightArc(0.1)       # die Linie ist rechts
    delay(10)
