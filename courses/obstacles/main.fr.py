# Éviter les obstacles
# Le capteur à ultrasons mesure la distance droit devant, en centimètres.
# Il voit comme le faisceau d'une lampe de poche : ce qui est à côté du faisceau reste caché.
# Là où la voie s'arrête, le robot regarde donc aussi à gauche et à droite.
from mbrobot import *

NEAR = 22               # centimètres : il ne va pas plus près
FREE = 50               # centimètres : la nouvelle voie doit être libre jusque-là
LOOK = 110              # millisecondes de rotation pour un regard de côté

def turn(direction):
    direction()         # gauche ou droite
    delay(LOOK)
    stop()
    delay(40)           # s'arrêter, puis mesurer

def look(direction, back):
    """Distance à côté du robot ; ensuite il regarde de nouveau devant."""
    turn(direction)
    distance = getDistance()
    turn(back)
    return distance

def is_free(far):
    return getDistance() > far and look(left, right) > NEAR and look(right, left) > NEAR

setSpeed(50)

while True:
    setLED(0)
    forward()
    while getDistance() > NEAR:
        delay(20)
    stop()

    setLED(1)
    direction = left if look(left, right) > look(right, left) else right
    turn(direction)
    far = FREE
    while not is_free(far):
        turn(direction)     # toujours dans le même sens, sinon il hésiterait dans un coin
        far = far - 3       # qui cherche longtemps se contente de moins
