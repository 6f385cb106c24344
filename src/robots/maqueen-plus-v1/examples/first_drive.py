# First drive
# A square with coloured lights.
# Change the numbers and see what happens!
from mbrobot_plus import *

colors = [LEDState.RED, LEDState.YELLOW, LEDState.GREEN, LEDState.BLUE]

setSpeed(50)

for color in colors:
    setLED(color)
    forward()
    delay(1200)
    left()
    delay(415)          # that is how long a quarter turn takes
    stop()
    delay(200)

setLED(LEDState.OFF)
