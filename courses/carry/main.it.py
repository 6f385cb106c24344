# Portare il blocco
# La pinza è al connettore servo S1: 30 gradi è aperta, 90 gradi è chiusa.
from mbrobot import *

OPEN = 30
CLOSED = 90
QUARTER_TURN = 363      # millisecondi per 90 gradi con setSpeed(50)

def turn(direction):
    direction()         # sinistra o destra
    delay(QUARTER_TURN)
    stop()
    delay(300)

def drive_to_line():
    forward()
    while irLeft.read_digital() == 1 and irRight.read_digital() == 1:
        delay(5)
    stop()
    delay(300)

setServo("S1", OPEN)
delay(500)

forward()               # fino al blocco, finché è tra le ganasce
while getDistance() > 4:
    delay(10)
stop()
setServo("S1", CLOSED)
delay(600)

forward()               # con il blocco nella pinza
delay(1500)
stop()
delay(300)
turn(left)
drive_to_line()
forward()               # oltre la linea, nella zona
delay(450)
stop()

setServo("S1", OPEN)
delay(600)
backward()              # il blocco resta lì
delay(800)
stop()
fillRGB(0, 80, 0)       # fatto!
