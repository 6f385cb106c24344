# Durch das Labyrinth
# Auftrag: Fahr durch den Gang bis zur schwarzen Linie im Ziel.
# Der Ultraschall misst nur nach vorne. Steht der Roboter vor einer Wand, muss er sich umschauen.
from mbrobot import *

QUARTER_TURN = 372      # Millisekunden für 90 Grad mit setSpeed(50)

setSpeed(50)
forward()
while getDistance() > 6:
    delay(10)
stop()
delay(200)
left()
delay(QUARTER_TURN)
stop()
# Eine Kurve ist geschafft. Wie wird daraus ein Programm für das ganze Labyrinth?
