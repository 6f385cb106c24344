# Labirinto con il paraurti
# Il robot va sempre un po' a destra, finché tocca un muro.
# Allora indietreggia e gira un po' a sinistra.
# Così segue a tentoni il muro di destra, a ogni angolo. L'arrivo è una linea nera.
from callibot import *

RADIUS = 0.15           # metri: il raggio della sua curva a destra
BACK = 250              # millisecondi per lasciare il muro
AWAY = 250              # millisecondi: di tanto si gira via dal muro

def is_touching():
    return tsValue() or tsLeftValue() or tsRightValue()

def is_dark():
    return irLeftValue() == 0 and irRightValue() == 0

def at_finish():
    """L'arrivo è scuro. Con il paraurti premuto pare scuro tutto: allora fermarsi e guardare ancora."""
    if not is_dark():
        return False
    stop()
    delay(100)
    return is_dark() and not is_touching()

setSpeed(20)

while not at_finish():
    rightArc(RADIUS)
    if is_touching():
        backward()
        delay(BACK)
        left()
        delay(AWAY)

stop()
setLED(1)               # fatto!
