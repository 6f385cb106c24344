# Einer Linie folgen
# Der mittlere Sensor soll auf der schwarzen Linie bleiben:
# 0 heisst dunkel, 1 heisst hell.
from mbrobot_plusV2 import *

setSpeed(40)

while True:
    if irL1.read_digital() == 0:        # die Linie ist links
        leftArc(0.06)
    elif irR1.read_digital() == 0:      # die Linie ist rechts
        rightArc(0.06)
    elif irM.read_digital() == 0:       # die Linie ist in der Mitte
        forward()
    delay(10)
