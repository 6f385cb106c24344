# Le grand tour
# Des lignes droites et des quarts de cercle de 20 cm de rayon : un morceau de chemin après l'autre.
from callibot import *

QUARTER = 1850          # millisecondes pour un quart de cercle avec setSpeed(20)

def straight(time):
    forward()
    delay(time)

def quarter(direction):
    direction(0.2)      # leftArc ou rightArc, rayon en mètres
    delay(QUARTER)

setSpeed(20)
straight(2600)
quarter(leftArc)
quarter(rightArc)
straight(600)
quarter(leftArc)
quarter(leftArc)
straight(1500)
quarter(leftArc)
quarter(rightArc)
straight(1200)
stop()
setLED(1)
