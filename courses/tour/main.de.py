# Rundreise
# Geraden und Viertelkreise von 20 cm Radius: ein Stück Weg nach dem andern.
from callibot import *

QUARTER = 1850          # Millisekunden für einen Viertelkreis mit setSpeed(20)

def straight(time):
    forward()
    delay(time)

def quarter(direction):
    direction(0.2)      # leftArc oder rightArc, Radius in Metern
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
