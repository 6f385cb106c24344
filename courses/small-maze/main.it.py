# Attraverso il labirinto
# Il robot misura solo dritto davanti. Davanti a un muro guarda prima a sinistra.
# Se anche lì c'è un muro, si va a destra. L'arrivo è una linea nera.
from mbrobot import *

QUARTER_TURN = 372      # millisecondi per 90 gradi con setSpeed(50)
NEAR = 6                # centimetri: fin qui si avvicina a un muro

def turn(direction):
    direction()         # sinistra o destra
    delay(QUARTER_TURN)
    stop()
    delay(200)          # fermarsi, poi misurare

def at_finish():
    return irLeft.read_digital() == 0 and irRight.read_digital() == 0

setSpeed(50)

while not at_finish():
    if getDistance() > NEAR:
        forward()
    else:
        stop()
        delay(200)
        turn(left)
        if getDistance() < 20:
            turn(right)
            turn(right)
    delay(10)

stop()
fillRGB(0, 80, 0)       # fatto!
