# Labirinto con la mano sinistra
# Compito: trova la via fino alla linea nera dell'arrivo.
# Le celle sono larghe 25 cm. Chi segue il muro a sinistra arriva all'arrivo.
from mbrobot import *

QUARTER_TURN = 372      # millisecondi per 90 gradi con setSpeed(50)
CELL = 1420             # millisecondi da una cella alla prossima

def turn(direction):
    direction()         # sinistra o destra
    delay(QUARTER_TURN)
    stop()
    delay(200)          # fermati prima di misurare

def drive_to_next_cell():
    forward()
    delay(CELL)
    stop()
    delay(200)

setSpeed(50)

turn(left)              # C'è un muro a sinistra?
print(getDistance(), "cm")
# Quando vai avanti, quando continui a girare? E quando sei arrivato?
