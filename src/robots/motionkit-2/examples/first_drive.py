# First drive
# A bit straight on, a turn, a curve.
# Change the numbers and see what happens!
from callimk import *

setSpeed(30)
setLED(1)
forward()
delay(1000)             # 1000 milliseconds are one second

left()                  # turns on the spot
delay(800)

rightArc(0.3)           # a curve to the right
delay(3000)

stop()
setLED(0)
print("Distance ahead:", getDistance(), "cm")
