# Labirinto con il paraurti
# Compito: avanza a tentoni nel corridoio con il paraurti, fino alla linea nera.
# tsValue() è 1 quando sono premute tutte e due le metà del paraurti, tsLeftValue() e tsRightValue() per una sola.
from callibot import *

QUARTER_TURN = 357      # millisecondi per 90 gradi con setSpeed(20)

def is_touching():
    return tsValue() or tsLeftValue() or tsRightValue()

setSpeed(20)
forward()
while not is_touching():
    delay(10)
backward()
delay(250)
stop()
# Sei al primo muro. E adesso, dove?
