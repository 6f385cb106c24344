# Einparken
# Die schwarze Linie liegt so, dass die Räder genau neben der Lücke stehen, sobald die Sensoren sie sehen.
from mbrobot_plusV2 import *

QUARTER_TURN = 590      # Millisekunden für 90 Grad mit setSpeed(40)
INTO_SPACE = 2300       # Millisekunden rückwärts in die Lücke

setSpeed(40)

forward()
while irM.read_digital() == 1:
    delay(5)
stop()
delay(300)

left()                  # das Heck zeigt zur Lücke
delay(QUARTER_TURN)
stop()
delay(300)

backward()
delay(INTO_SPACE)
stop()
setLED(1)
