# Abstand halten
# Auftrag: Fahr bis 10 cm vor die Wand und rückwärts zurück zum Start.
# getDistance() misst den Abstand nach vorne in Zentimetern.
from mbrobot import *

setSpeed(50)
forward()
delay(1000)
print(getDistance(), "cm")
# Wie fährt der Roboter weiter, solange der Abstand grösser als 10 ist? Tipp: while
stop()
