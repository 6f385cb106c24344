# Lights and brightness
# The lights below show how bright the ground is
# under the middle sensor.
from microbit import *
from mbrobot_plusV2 import *

for position in range(4):               # one light after the other
    posRGB(position, 0, 80, 40)
    delay(300)

setSpeed(20)
forward()

for step in range(100):
    value = irM.read_analog()           # about 100 on black, 230 on light ground
    fillRGB(255 - value, 0, value)
    setLED(irL1.read_digital(), irR1.read_digital())
    delay(50)

stop()
setLED(0)
clearRGB()
print("Measured last:", value)
