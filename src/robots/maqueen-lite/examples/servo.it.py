# Un servo al connettore S1
# C'è attaccata una pinza: 30 è aperta, 90 è chiusa.
# Sotto «Dispositivo» scegli qualcos'altro.
from mbrobot import *

OPEN = 30
CLOSED = 90

for turn in range(3):
    setServo("S1", OPEN)
    delay(1000)
    setServo("S1", CLOSED)
    delay(1000)

for angle in range(CLOSED, OPEN, -5):   # aprire piano
    setServo("S1", angle)
    delay(100)
