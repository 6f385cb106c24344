# Croisement et trous
# Tâche : suis la ligne par le croisement et les trous, et reviens au départ.
# Réfléchis d'abord : lesquels des cinq capteurs voient du foncé dans un angle, au croisement, dans un trou ?
from mbrobot_plusV2 import *

def is_dark(sensor):
    return sensor.read_digital() == 0

setSpeed(40)

while True:
    if is_dark(irL1) and not is_dark(irR1):
        leftArc(0.1)
    elif is_dark(irR1) and not is_dark(irL1):
        rightArc(0.1)
    else:
        forward()
    # irL2 et irR2 sont les extérieurs. Que fais-tu quand ils voient du foncé ?
    delay(10)
