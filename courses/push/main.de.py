# Klotz schieben
# Sehen die Liniensensoren die schwarze Linie, liegt der Klotz vor dem Roboter schon im Feld.
from mbrobot import *

setSpeed(50)

forward()
while irLeft.read_digital() == 1 and irRight.read_digital() == 1:
    delay(10)
stop()
delay(300)

backward()              # der Klotz bleibt liegen
delay(1000)
stop()
fillRGB(0, 80, 0)       # geschafft!
