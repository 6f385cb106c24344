# Vicolo delle punte
# Il sensore a ultrasuoni vede le punte come muri. Al centro del vicolo la sua fine è a 9 cm dal sensore.
from mbrobot_plusV2 import *

NEAR = 9                # centimetri
QUARTER_TURN = 590      # millisecondi per 90 gradi con setSpeed(40)

def drive_to_end():
    forward()
    while getDistance() > NEAR:
        delay(10)
    stop()
    delay(200)

def turn(direction):
    direction()         # sinistra o destra
    delay(QUARTER_TURN)
    stop()
    delay(200)

setSpeed(40)

for direction in (left, left, right, right):
    drive_to_end()
    turn(direction)
drive_to_end()
