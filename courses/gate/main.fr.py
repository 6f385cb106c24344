# La porte coulissante
# À la ligne noire, le robot attend que la porte soit fermée et qu'elle s'ouvre de nouveau.
# Ainsi il a le plus de temps pour passer.
from mbrobot import *

FREE = 50               # centimètres : la porte n'est jamais si loin

setSpeed(60)

forward()
while irLeft.read_digital() == 1:
    delay(5)
stop()

setLED(1)
while getDistance() > FREE:     # ouverte, mais pour combien de temps ?
    delay(20)
while getDistance() < FREE:     # fermée
    delay(20)
setLED(0)

forward()
delay(2900)
stop()
fillRGB(0, 80, 0)       # réussi !
