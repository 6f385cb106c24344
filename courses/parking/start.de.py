# Einparken
# Auftrag: Parke rückwärts in der Lücke, ohne etwas zu berühren.
# Die schwarze Linie zeigt, wo du zum Drehen hältst. irM meldet 0 auf dunklem Boden.
from mbrobot_plusV2 import *

setSpeed(40)

forward()
while irM.read_digital() == 1:
    delay(5)
stop()
# Jetzt steht der Roboter neben der Lücke. Wie kommt er rückwärts hinein?
