# Lichter und Helligkeit
# Die Lichter unten zeigen, wie hell der Boden
# unter dem mittleren Sensor ist.
from microbit import *
from mbrobot_plusV2 import *

for position in range(4):               # ein Licht nach dem anderen
    posRGB(position, 0, 80, 40)
    delay(300)

setSpeed(20)
forward()

for step in range(100):
    value = irM.read_analog()           # etwa 100 auf Schwarz, 230 auf hellem Boden
    fillRGB(255 - value, 0, value)
    setLED(irL1.read_digital(), irR1.read_digital())
    delay(50)

stop()
setLED(0)
clearRGB()
print("Zuletzt gemessen:", value)
