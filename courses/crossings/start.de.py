# Kreuzung und Lücken
# Auftrag: Folge der Linie über die Kreuzung und die Lücken, zurück zum Start.
# Überlege zuerst: Welche der fünf Sensoren sehen dunkel an einer Ecke, auf der Kreuzung, in einer Lücke?
from mbrobot_plusV2 import *

def is_dark(sensor):
    return sensor.read_digital() == 0

setSpeed(40)

while True:
    if is_dark(irL1) and not is_dark(irR1):
        leftArc(0.1)
    elif is_dark(irR1) and not is_dark(irL1):
        rightArc(0.1)
    else:
        forward()
    # irL2 und irR2 liegen aussen. Was tust du, wenn sie dunkel sehen?
    delay(10)
