# Durch das Labyrinth
# Der Roboter misst nur nach vorne. Steht er vor einer Wand, schaut er zuerst nach links.
# Ist dort auch eine Wand, geht es rechts weiter. Das Ziel ist eine schwarze Linie.
from mbrobot import *

QUARTER_TURN = 372      # Millisekunden für 90 Grad mit setSpeed(50)
NEAR = 6                # Zentimeter: so nahe fährt er an eine Wand heran

def turn(direction):
    direction()         # left oder right
    delay(QUARTER_TURN)
    stop()
    delay(200)          # ruhig stehen, dann erst messen

def at_finish():
    return irLeft.read_digital() == 0 and irRight.read_digital() == 0

setSpeed(50)

while not at_finish():
    if getDistance() > NEAR:
        forward()
    else:
        stop()
        delay(200)
        turn(left)
        if getDistance() < 20:
            turn(right)
            turn(right)
    delay(10)

stop()
fillRGB(0, 80, 0)       # geschafft!
