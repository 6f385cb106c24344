# Il giro
# Rettilinei e quarti di cerchio con raggio di 20 cm: un pezzo di strada dopo l'altro.
from callibot import *

QUARTER = 1850          # millisecondi per un quarto di cerchio con setSpeed(20)

def straight(time):
    forward()
    delay(time)

def quarter(direction):
    direction(0.2)      # leftArc o rightArc, raggio in metri
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
