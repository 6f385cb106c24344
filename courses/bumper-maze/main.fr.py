# Labyrinthe avec pare-chocs
# Le robot va toujours un peu à droite, jusqu'à ce qu'il touche un mur.
# Alors il recule et tourne un peu à gauche.
# Il suit ainsi à tâtons le mur de droite, à chaque coin. L'arrivée est une ligne noire.
from callibot import *

RADIUS = 0.15           # mètres : le rayon de son virage à droite
BACK = 250              # millisecondes pour quitter le mur
AWAY = 250              # millisecondes : il se détourne du mur d'autant

def is_touching():
    return tsValue() or tsLeftValue() or tsRightValue()

def is_dark():
    return irLeftValue() == 0 and irRightValue() == 0

def at_finish():
    """L'arrivée est sombre. Avec le pare-chocs pressé, tout paraît sombre aussi : alors s'arrêter et regarder encore."""
    if not is_dark():
        return False
    stop()
    delay(100)
    return is_dark() and not is_touching()

setSpeed(20)

while not at_finish():
    rightArc(RADIUS)
    if is_touching():
        backward()
        delay(BACK)
        left()
        delay(AWAY)

stop()
setLED(1)               # réussi !
