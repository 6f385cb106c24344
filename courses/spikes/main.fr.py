# Allée des pics
# Le capteur à ultrasons voit les pics comme des murs. Au milieu de l'allée, son bout est à 9 cm du capteur.
from mbrobot_plusV2 import *

NEAR = 9                # centimètres
QUARTER_TURN = 590      # millisecondes pour 90 degrés avec setSpeed(40)

def drive_to_end():
    forward()
    while getDistance() > NEAR:
        delay(10)
    stop()
    delay(200)

def turn(direction):
    direction()         # gauche ou droite
    delay(QUARTER_TURN)
    stop()
    delay(200)

setSpeed(40)

for direction in (left, left, right, right):
    drive_to_end()
    turn(direction)
drive_to_end()
