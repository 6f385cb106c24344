# Einer Linie folgen
# Die zwei mittleren Sensoren sehen die Linie:
# Der Roboter lenkt dorthin, wo es dunkel ist.
from mbrobot_plus import *

setSpeed(40)
forward()

while True:
    left_light = irL1.read_digital()
    right_light = irR1.read_digital()
    if left_light and not right_light:
        rightArc(0.1)
    elif right_light and not left_light:
        leftArc(0.1)
    elif not left_light:
        forward()
    # Sehen beide hellen Boden, fährt der Roboter weiter wie bisher:
    # So findet er die Linie wieder.
    delay(10)
