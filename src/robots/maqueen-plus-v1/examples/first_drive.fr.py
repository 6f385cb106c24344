# Premier trajet
# Un carré avec des lumières de couleur.
# Change les nombres et regarde ce qui se passe !
from mbrobot_plus import *

colors = [LEDState.RED, LEDState.YELLOW, LEDState.GREEN, LEDState.BLUE]

setSpeed(50)

for color in colors:
    setLED(color)
    forward()
    delay(1200)
    left()
    delay(415)          # c'est le temps d'un quart de tour
    stop()
    delay(200)

setLED(LEDState.OFF)
