# Round trip
# Straights and quarter circles of 20 cm radius: one piece of the way after the other.
from callibot import *

QUARTER = 1850          # milliseconds for a quarter circle with setSpeed(20)

def straight(time):
    forward()
    delay(time)

def quarter(direction):
    direction(0.2)      # leftArc or rightArc, radius in metres
    delay(QUARTER)

setSpeed(20)
straight(2600)
quarter(leftArc)
quarter(rightArc)
straight(600)
quarter(leftArc)
quarter(leftArc)
straight(1500)
quarter(leftArc)
quarter(rightArc)
straight(1200)
stop()
setLED(1)
