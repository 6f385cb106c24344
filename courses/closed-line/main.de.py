# Der Linie folgen
# Unter dem Roboter sind zwei Sensoren. Sie melden 1 auf hellem und 0 auf dunklem Boden.
# Auf der Linie sehen beide Sensoren dunkel.
from mbrobot import *

setSpeed(40)

while True:
    left_bright = irLeft.read_digital()
    right_bright = irRight.read_digital()
    if not left_bright and not right_bright:
        forward()           # mitten auf der Linie
    elif not left_bright:
        leftArc(0.06)       # die Linie liegt links
    elif not right_bright:
        rightArc(0.06)      # die Linie liegt rechts
    # sonst: Linie verloren, weiter wie zuletzt
    delay(10)
