# Portare il blocco
# Compito: prendi il blocco con la pinza e portalo nella zona d'arrivo.
# La pinza è al connettore servo S1: 30 gradi è aperta, 90 gradi è chiusa.
from mbrobot import *

OPEN = 30
CLOSED = 90

setServo("S1", OPEN)
delay(500)

forward()               # finché il blocco è tra le ganasce
while getDistance() > 4:
    delay(10)
stop()
setServo("S1", CLOSED)
delay(600)
# Hai il blocco. Come arriva nella zona?
