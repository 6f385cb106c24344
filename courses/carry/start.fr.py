# Porter le bloc
# Tâche : prends le bloc avec la pince et porte-le dans la zone d'arrivée.
# La pince est au connecteur servo S1 : 30 degrés, c'est ouvert ; 90 degrés, c'est fermé.
from mbrobot import *

OPEN = 30
CLOSED = 90

setServo("S1", OPEN)
delay(500)

forward()               # jusqu'à ce que le bloc soit entre les mâchoires
while getDistance() > 4:
    delay(10)
stop()
setServo("S1", CLOSED)
delay(600)
# Tu as le bloc. Comment arrive-t-il dans la zone ?
