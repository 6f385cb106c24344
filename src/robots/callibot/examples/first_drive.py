# First drive
# A bit straight on, a circle, a turn.
# Change the numbers and see what happens!
from callibot import *

setSpeed(50)
setLED(1)
forward()
delay(1000)             # 1000 milliseconds are one second

rightArc(0.15)          # a circle with a radius of 15 cm
delay(4000)

left()                  # turns on the spot
delay(600)

stop()
setLED(0)
print("Distance ahead:", round(getDistance()), "cm")
