# First drive
# Forward, a bend, backward. Change the numbers and see what happens!
from mbrobot_plusV3 import *

setSpeed(50)
setLED(2)               # green lamps

forward()
delay(2000)
motL.rotate(40)         # the left wheel slower than the right one: a bend
motR.rotate(90)
delay(3000)
setLEDs(0, 3)           # left off, right yellow
right()                 # turns on the spot
delay(600)
backward()
delay(1000)
stop()

setLED(0)
beep()
