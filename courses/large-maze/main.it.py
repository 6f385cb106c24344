# Labirinto con la mano sinistra
# La regola della mano sinistra: in ogni cella guardare prima a sinistra, poi dritto, poi a destra.
# Chi segue il muro a sinistra arriva dappertutto. L'arrivo è una linea nera.
from microbit import running_time
from mbrobot import *

QUARTER_TURN = 372      # millisecondi per 90 gradi con setSpeed(50)
CELL = 1420             # millisecondi da una cella alla prossima
MIDDLE = 7              # centimetri fino al muro davanti quando il robot è al centro della cella

def turn(direction):
    direction()         # sinistra o destra
    delay(QUARTER_TURN)
    stop()
    delay(200)          # fermati prima di misurare

def at_finish():
    return irLeft.read_digital() == 0 and irRight.read_digital() == 0

def drive_to_next_cell():
    """Avanza di una cella. Con un muro davanti la sua distanza è più precisa del tempo."""
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
    while getDistance() < 2 * MIDDLE:   # c'è un muro
        turn(right)
    drive_to_next_cell()

fillRGB(0, 80, 0)       # fatto!
