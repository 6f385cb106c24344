# Percorrere un quadrato
# Quattro volte: dritto, poi un quarto di giro a sinistra.
from mbrobot import *

SIDE = 1500             # millisecondi per un lato
QUARTER_TURN = 371      # millisecondi per 90 gradi. Prova altri numeri!

setSpeed(50)

for side in range(4):
    forward()
    delay(SIDE)
    stop()
    delay(200)
    left()
    delay(QUARTER_TURN)
    stop()
    delay(200)
