# Il quadrato
# Quattro volte lo stesso: un lato, un quarto di giro.
from mbrobot import *

SIDE = 2200             # millisecondi per 40 cm con setSpeed(50)
QUARTER_TURN = 372      # millisecondi per 90 gradi

setSpeed(50)

for i in range(4):
    forward()
    delay(SIDE)
    stop()
    delay(200)          # fermarsi prima di girare
    left()
    delay(QUARTER_TURN)
    stop()
    delay(200)
