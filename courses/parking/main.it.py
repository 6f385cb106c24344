# Parcheggiare
# Quando i sensori vedono la linea nera, le ruote sono proprio accanto al posto.
from mbrobot_plusV2 import *

QUARTER_TURN = 590      # millisecondi per 90 gradi con setSpeed(40)
INTO_SPACE = 2300       # millisecondi all'indietro fin dentro il posto

setSpeed(40)

forward()
while irM.read_digital() == 1:
    delay(5)
stop()
delay(300)

left()                  # il retro è rivolto verso il posto
delay(QUARTER_TURN)
stop()
delay(300)

backward()
delay(INTO_SPACE)
stop()
setLED(1)
