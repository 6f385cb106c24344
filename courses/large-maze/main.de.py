# Labyrinth mit der linken Hand
# Die Linke-Hand-Regel: In jeder Zelle zuerst nach links schauen, dann geradeaus, dann nach rechts.
# Wer immer der linken Wand folgt, kommt an jeden Ort. Das Ziel ist eine schwarze Linie.
from microbit import running_time
from mbrobot import *

QUARTER_TURN = 372      # Millisekunden für 90 Grad mit setSpeed(50)
CELL = 1420             # Millisekunden von einer Zelle zur nächsten
MIDDLE = 7              # Zentimeter bis zur Wand vorne, wenn der Roboter mitten in der Zelle steht

def turn(direction):
    direction()         # left oder right
    delay(QUARTER_TURN)
    stop()
    delay(200)          # ruhig stehen, dann erst messen

def at_finish():
    return irLeft.read_digital() == 0 and irRight.read_digital() == 0

def drive_to_next_cell():
    """Fährt eine Zelle weit. Steht vorne eine Wand, ist ihr Abstand genauer als die Zeit."""
    start = running_time()
    forward()
    while not at_finish():
        distance = getDistance()
        if distance <= MIDDLE:
            break
        if running_time() - start > CELL and distance > 2 * MIDDLE:
            break
        delay(5)
    stop()
    delay(200)

setSpeed(50)

while not at_finish():
    turn(left)
    while getDistance() < 2 * MIDDLE:   # hier ist eine Wand
        turn(right)
    drive_to_next_cell()

fillRGB(0, 80, 0)       # geschafft!
