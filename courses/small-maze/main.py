# Durch das Labyrinth
# Der Roboter misst nur nach vorne. Vor einer Wand schaut er zuerst nach links.
# Ist dort auch eine Wand, dreht er um und nimmt den Weg nach rechts.
from mbrobot import *

QUARTER_TURN = 415      # Millisekunden für 90 Grad mit setSpeed(50)
NEAR = 6                # Zentimeter: so nahe fährt er an eine Wand heran

def turn_left():
    left()
    delay(QUARTER_TURN)
    stop()
    delay(200)          # ruhig stehen, dann erst messen

def turn_around():
    turn_left()
    turn_left()

def at_finish():
    return irLeft.read_digital() == 0 and irRight.read_digital() == 0

setSpeed(50)

while not at_finish():
    if getDistance() > NEAR:
        forward()
    else:
        stop()
        delay(200)
        turn_left()
        if getDistance() < 20:
            turn_around()
    delay(10)

stop()
fillRGB(0, 80, 0)       # geschafft!
