# Labyrinthe avec la main gauche
# La règle de la main gauche : dans chaque case, regarder d'abord à gauche, puis tout droit, puis à droite.
# Qui suit le mur de gauche arrive partout. L'arrivée est une ligne noire.
from microbit import running_time
from mbrobot import *

QUARTER_TURN = 372      # millisecondes pour 90 degrés avec setSpeed(50)
CELL = 1420             # millisecondes d'une case à la suivante
MIDDLE = 7              # centimètres jusqu'au mur devant quand le robot est au milieu de la case

def turn(direction):
    direction()         # gauche ou droite
    delay(QUARTER_TURN)
    stop()
    delay(200)          # arrête-toi avant de mesurer

def at_finish():
    return irLeft.read_digital() == 0 and irRight.read_digital() == 0

def drive_to_next_cell():
    """Avance d'une case. Avec un mur devant, sa distance est plus exacte que le temps."""
    start = running_time()
    forward()
    while not at_finish():
        distance = getDistance()
        if distance <= MIDDLE:
            break
        if running_time() - start > CELL and distance > 2 * MIDDLE:
            break
        delay(5)
    stop()
    delay(200)

setSpeed(50)

while not at_finish():
    turn(left)
    while getDistance() < 2 * MIDDLE:   # il y a un mur
        turn(right)
    drive_to_next_cell()

fillRGB(0, 80, 0)       # réussi !
