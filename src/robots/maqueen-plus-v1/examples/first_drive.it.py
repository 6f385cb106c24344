# Primo viaggio
# Un quadrato con luci colorate.
# Cambia i numeri e guarda che cosa succede!
from mbrobot_plus import *

colors = [LEDState.RED, LEDState.YELLOW, LEDState.GREEN, LEDState.BLUE]

setSpeed(50)

for color in colors:
    setLED(color)
    forward()
    delay(1200)
    left()
    delay(415)          # tanto dura un quarto di giro
    stop()
    delay(200)

setLED(LEDState.OFF)
