# Erste Fahrt
# Ein Quadrat mit farbigen Lichtern.
# Verändere die Zahlen und schau, was passiert!
from mbrobot_plus import *

colors = [LEDState.RED, LEDState.YELLOW, LEDState.GREEN, LEDState.BLUE]

setSpeed(50)

for color in colors:
    setLED(color)
    forward()
    delay(1200)
    left()
    delay(415)          # so lange dauert eine Vierteldrehung
    stop()
    delay(200)

setLED(LEDState.OFF)
