# Luci e chiarezza
# Le luci sotto mostrano quanto è chiaro il pavimento
# sotto il sensore centrale.
from microbit import *
from mbrobot_plusV2 import *

for position in range(4):               # una luce dopo l'altra
    posRGB(position, 0, 80, 40)
    delay(300)

setSpeed(20)
forward()

for step in range(100):
    value = irM.read_analog()           # circa 100 sul nero, 230 sul chiaro
    fillRGB(255 - value, 0, value)
    setLED(irL1.read_digital(), irR1.read_digital())
    delay(50)

stop()
setLED(0)
clearRGB()
print("Ultima misura:", value)
