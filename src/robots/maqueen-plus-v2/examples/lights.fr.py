# Lumières et clarté
# Les lumières du dessous montrent si le sol est clair
# sous le capteur du milieu.
from microbit import *
from mbrobot_plusV2 import *

for position in range(4):               # une lumière après l'autre
    posRGB(position, 0, 80, 40)
    delay(300)

setSpeed(20)
forward()

for step in range(100):
    value = irM.read_analog()           # environ 100 sur du noir, 230 sur un sol clair
    fillRGB(255 - value, 0, value)
    setLED(irL1.read_digital(), irR1.read_digital())
    delay(50)

stop()
setLED(0)
clearRGB()
print("Dernière mesure :", value)
