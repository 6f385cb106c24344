# Un servo al connettore P1
# C'è attaccata una pinza: 30 è aperta, 90 è chiusa.
# Sotto «Dispositivo» scegli qualcos'altro.
from mbrobot_plusV2 import *

OPEN = 30
CLOSED = 90

for turn in range(3):
    setServo("P1", OPEN)
    delay(1000)
    setServo("P1", CLOSED)
    delay(1000)

for angle in range(CLOSED, OPEN, -5):   # aprire piano
    setServo("P1", angle)
    delay(100)
