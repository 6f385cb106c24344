# First drive
# A square and a circle. Change the numbers and see what happens!
from mbrobot import *

setSpeed(50)
setLED(1)

for side in range(4):
    forward()
    delay(1200)
    left()
    delay(363)          # that is how long a quarter turn takes
    stop()
    delay(200)

setLED(0)
fillRGB(0, 60, 0)
rightArc(0.15)          # a circle with a radius of 15 cm
delay(6250)
stop()
clearRGB()
