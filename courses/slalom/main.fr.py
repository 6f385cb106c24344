# Slalom
# Un demi-cercle autour de chaque poteau : une fois à droite, une fois à gauche.
from mbrobot import *

HALF_CIRCLE = 3825      # millisecondes pour 180 degrés avec setSpeed(50)

def half_circle(arc):
    arc(0.2)            # rightArc ou leftArc, rayon en mètres
    delay(HALF_CIRCLE)
    stop()
    delay(300)          # chaque demi-cercle commence à l'arrêt

setSpeed(50)

for i in range(2):
    half_circle(rightArc)
    half_circle(leftArc)
fillRGB(0, 80, 0)       # réussi !
