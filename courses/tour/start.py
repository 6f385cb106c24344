# Round trip
# Task: drive past checkpoints 1 to 5 and then to the target.
# leftArc(0.2) and rightArc(0.2) drive arcs of 20 cm radius. How long does a quarter circle take?
from callibot import *

setSpeed(20)

forward()
delay(2600)
leftArc(0.2)
delay(1000)
stop()
# And then?
