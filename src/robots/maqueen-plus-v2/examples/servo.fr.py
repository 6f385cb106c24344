# Un servo au connecteur P1
# Une pince y est fixée : 30 est ouvert, 90 est fermé.
# Sous « Appareil », tu choisis autre chose.
from mbrobot_plusV2 import *

OPEN = 30
CLOSED = 90

for turn in range(3):
    setServo("P1", OPEN)
    delay(1000)
    setServo("P1", CLOSED)
    delay(1000)

for angle in range(CLOSED, OPEN, -5):   # ouvrir lentement
    setServo("P1", angle)
    delay(100)
