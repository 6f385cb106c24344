# Parking
# The black line is where the wheels stand just beside the space once the sensors see it.
from mbrobot_plusV2 import *

QUARTER_TURN = 590      # milliseconds for 90 degrees with setSpeed(40)
INTO_SPACE = 2300       # milliseconds backwards into the space

setSpeed(40)

forward()
while irM.read_digital() == 1:
    delay(5)
stop()
delay(300)

left()                  # the back points at the space
delay(QUARTER_TURN)
stop()
delay(300)

backward()
delay(INTO_SPACE)
stop()
setLED(1)
