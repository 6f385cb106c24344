# Spingere il blocco
# Compito: spingi il blocco del tutto nella zona d'arrivo.
# La linea nera ti dice quando basta: allora irLeft.read_digital() dà 0.
from mbrobot import *

setSpeed(50)

forward()
delay(2000)
stop()
# Come fa il robot ad andare proprio fino alla linea?
