# Porter le bloc
# La pince est au connecteur servo S1 : 30 degrés, c'est ouvert ; 90 degrés, c'est fermé.
from mbrobot import *

OPEN = 30
CLOSED = 90
QUARTER_TURN = 363      # millisecondes pour 90 degrés avec setSpeed(50)

def turn(direction):
    direction()         # gauche ou droite
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

forward()               # jusqu'au bloc, pour qu'il soit entre les mâchoires
while getDistance() > 4:
    delay(10)
stop()
setServo("S1", CLOSED)
delay(600)

forward()               # avec le bloc dans la pince
delay(1500)
stop()
delay(300)
turn(left)
drive_to_line()
forward()               # par-dessus la ligne, dans la zone
delay(450)
stop()

setServo("S1", OPEN)
delay(600)
backward()              # le bloc reste là
delay(800)
stop()
fillRGB(0, 80, 0)       # réussi !
