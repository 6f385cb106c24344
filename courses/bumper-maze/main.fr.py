# Labyrinthe avec pare-chocs
# Le pare-chocs dit quand le robot touche un mur. À chaque mur, il recule et essaie à gauche.
# S'il y a tout de suite un mur, il va de l'autre côté. L'arrivée est une ligne noire.
from calliopemini import running_time
from callibot import *

QUARTER_TURN = 357      # millisecondes pour 90 degrés avec setSpeed(20)
SHORT = 1500            # millisecondes : un mur qui vient si vite ferme le chemin

def turn(direction):
    direction()         # gauche ou droite
    delay(QUARTER_TURN)
    stop()
    delay(200)

def is_touching():
    return tsValue() or tsLeftValue() or tsRightValue()

def drive():
    """Roule jusqu'au prochain mur. Donne les millisecondes du trajet, ou 0 à l'arrivée."""
    start = running_time()
    forward()
    while True:
        is_dark = irLeftValue() == 0 and irRightValue() == 0
        if is_touching():   # quand le pare-chocs est pressé, les valeurs des capteurs de ligne ne veulent rien dire
            way = running_time() - start
            backward()
            delay(250)
            stop()
            delay(200)
            return way
        if is_dark:
            stop()
            return 0
        delay(10)

setSpeed(20)
way = drive()

while way > 0:
    turn(left)
    way = drive()
    if 0 < way < SHORT:
        turn(left)      # deux quarts de tour : l'autre chemin
        turn(left)
        way = drive()

setLED(1)               # réussi !
