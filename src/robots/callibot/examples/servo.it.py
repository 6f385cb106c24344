# Un servo al connettore S1
# C'è attaccata una pinza: 30 è aperta, 90 è chiusa.
# callibot non ha un comando per i servo:
# il programma manda i byte da sé.
from callibot import *

OPEN = 30
CLOSED = 90


def set_servo(angle):
    # 0x14 è S1, 0x15 è S2; l'angolo va da 0 a 180
    i2c.write(0x20, bytes([0x14, angle]))


for turn in range(3):
    set_servo(OPEN)
    delay(1000)
    set_servo(CLOSED)
    delay(1000)

for angle in range(CLOSED, OPEN, -5):   # aprire piano
    set_servo(angle)
    delay(100)
