# Labyrinthe avec la main gauche
# Tâche : trouve le chemin jusqu'à la ligne noire de l'arrivée.
# Les cases ont 25 cm de large. Qui suit le mur de gauche arrive au but.
from mbrobot import *

QUARTER_TURN = 372      # millisecondes pour 90 degrés avec setSpeed(50)
CELL = 1420             # millisecondes d'une case à la suivante

def turn(direction):
    direction()         # gauche ou droite
    delay(QUARTER_TURN)
    stop()
    delay(200)          # arrête-toi avant de mesurer

def drive_to_next_cell():
    forward()
    delay(CELL)
    stop()
    delay(200)

setSpeed(50)

turn(left)              # Y a-t-il un mur à gauche ?
print(getDistance(), "cm")
# Quand roules-tu, quand continues-tu à tourner ? Et quand es-tu au but ?
