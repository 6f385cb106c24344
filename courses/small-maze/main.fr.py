# À travers le labyrinthe
# Le robot ne mesure que droit devant. Devant un mur, il regarde d'abord à gauche.
# S'il y a aussi un mur, le chemin continue à droite. L'arrivée est une ligne noire.
from mbrobot import *

QUARTER_TURN = 372      # millisecondes pour 90 degrés avec setSpeed(50)
NEAR = 6                # centimètres : il s'approche jusque-là d'un mur

def turn(direction):
    direction()         # gauche ou droite
    delay(QUARTER_TURN)
    stop()
    delay(200)          # s'arrêter, puis mesurer

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
fillRGB(0, 80, 0)       # réussi !
