# Erste Fahrt
# Vorwärts, eine Kurve, rückwärts.
# Verändere die Zahlen und schau, was passiert!
from mbrobot_plusV2 import *

setSpeed(50)
setLED(1)

forward()
delay(2000)
leftArc(0.2)            # ein Bogen mit 20 cm Radius
delay(4000)
setLED(0, 1)
right()                 # dreht sich an Ort
delay(800)
backward()
delay(1000)
stop()

setLED(0)
beep()
