# Das Schiebetor
# Auftrag: Fahr durch das Tor ins Ziel, ohne das Schiebetor zu berühren.
# Tipp: Miss an der Haltelinie mit getDistance(), ob der Weg frei ist.
from mbrobot import *

setSpeed(60)

forward()
while irLeft.read_digital() == 1:
    delay(5)
stop()
# Du stehst an der Haltelinie. Worauf wartest du?
while True:
    print(getDistance(), "cm")
    delay(200)
