# Labirinto con il paraurti
# Il paraurti dice quando il robot tocca un muro. A ogni muro indietreggia e prova a sinistra.
# Se c'è subito un muro, va dall'altra parte. L'arrivo è una linea nera.
from calliopemini import running_time
from callibot import *

QUARTER_TURN = 357      # millisecondi per 90 gradi con setSpeed(20)
SHORT = 1500            # millisecondi: un muro che arriva così presto chiude la via

def turn(direction):
    direction()         # sinistra o destra
    delay(QUARTER_TURN)
    stop()
    delay(200)

def is_touching():
    return tsValue() or tsLeftValue() or tsRightValue()

def drive():
    """Va fino al prossimo muro. Dà i millisecondi del tragitto, o 0 all'arrivo."""
    start = running_time()
    forward()
    while True:
        is_dark = irLeftValue() == 0 and irRightValue() == 0
        if is_touching():   # finché il paraurti è premuto, i valori dei sensori di linea non dicono niente
            way = running_time() - start
            backward()
            delay(250)
            stop()
            delay(200)
            return way
        if is_dark:
            stop()
            return 0
        delay(10)

setSpeed(20)
way = drive()

while way > 0:
    turn(left)
    way = drive()
    if 0 < way < SHORT:
        turn(left)      # due quarti di giro: l'altra via
        turn(left)
        way = drive()

setLED(1)               # fatto!
