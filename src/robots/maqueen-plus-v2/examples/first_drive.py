# First drive
# Forward, a bend, backward. Change the numbers and see what happens!
from mbrobot_plusV2 import *

setSpeed(50)
setLED(1)

forward()
delay(2000)
leftArc(0.2)            # an arc with a radius of 20 cm
delay(4000)
setLED(0, 1)
right()                 # turns on the spot
delay(800)
backward()
delay(1000)
stop()

setLED(0)
beep()
