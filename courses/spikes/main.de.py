# Stachelgasse
# Der Ultraschall sieht Stacheln wie Wände. In der Mitte der Gasse ist das Ende 9 cm vor dem Sensor.
from mbrobot_plusV2 import *

NEAR = 9                # Zentimeter
QUARTER_TURN = 590      # Millisekunden für 90 Grad mit setSpeed(40)

def drive_to_end():
    forward()
    while getDistance() > NEAR:
        delay(10)
    stop()
    delay(200)

def turn(direction):
    direction()         # left oder right
    delay(QUARTER_TURN)
    stop()
    delay(200)

setSpeed(40)

for direction in (left, left, right, right):
    drive_to_end()
    turn(direction)
drive_to_end()
