# Svuotare il cerchio
# Compito: spingi tutti e tre i blocchi fuori dal cerchio, nelle zone al bordo.
# Consiglio: gira sul posto finché vedi un blocco, vai, e fermati sulla linea nera.
from mbrobot import *

def on_line():
    return irLeft.read_digital() == 0 or irRight.read_digital() == 0

setSpeed(45)

while getDistance() > 28:   # ancora nessun blocco in vista
    left()
    delay(35)
    stop()
    delay(40)               # fermati prima di misurare

forward()
while not on_line():
    delay(5)
stop()
# Un blocco è alla linea. E poi?
