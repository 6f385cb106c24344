# Stachelgasse
# Auftrag: Fahr durch die Gasse ins Ziel, ohne die Stacheln zu berühren.
# Der Ultraschall sieht Stacheln wie Wände.
from mbrobot_plusV2 import *

setSpeed(40)

forward()
while getDistance() > 9:
    delay(10)
stop()
# Jetzt nach links. Wie lange dauert eine Vierteldrehung?
