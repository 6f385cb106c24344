# Slalom
# Un semicerchio attorno a ogni paletto: una volta a destra, una volta a sinistra.
from mbrobot import *

HALF_CIRCLE = 3825      # millisecondi per 180 gradi con setSpeed(50)

def half_circle(arc):
    arc(0.2)            # rightArc o leftArc, raggio in metri
    delay(HALF_CIRCLE)
    stop()
    delay(300)          # ogni semicerchio comincia da fermo

setSpeed(50)

for i in range(2):
    half_circle(rightArc)
    half_circle(leftArc)
fillRGB(0, 80, 0)       # fatto!
