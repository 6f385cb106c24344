# La porte coulissante
# À la ligne noire, le robot attend que la porte soit fermée et qu'elle s'ouvre de nouveau.
# Ainsi il a le plus de temps pour passer.
from mbrobot import *

FREE = 50               # centimètres : la porte n'est jamais si loin

def distance():
    """La plus petite de trois mesures : si un écho se perd, getDistance() donne 255."""
    return min(getDistance(), getDistance(), getDistance())

setSpeed(60)

forward()
while irLeft.read_digital() == 1:
    delay(5)
stop()

setLED(1)
while distance() > FREE:        # ouverte, mais pour combien de temps ?
    delay(20)
while distance() < FREE:        # fermée
    delay(20)
setLED(0)

forward()
delay(2900)
stop()
fillRGB(0, 80, 0)       # réussi !
