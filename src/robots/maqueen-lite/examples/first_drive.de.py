# Erste Fahrt
# Ein Quadrat und ein Kreis.
# Verändere die Zahlen und schau, was passiert!
from mbrobot import *

setSpeed(50)
setLED(1)

for side in range(4):
    forward()
    delay(1200)
    left()
    delay(363)          # so lange dauert eine Vierteldrehung
    stop()
    delay(200)

setLED(0)
fillRGB(0, 60, 0)
rightArc(0.15)          # ein Kreis mit 15 cm Radius
delay(6250)
stop()
clearRGB()
