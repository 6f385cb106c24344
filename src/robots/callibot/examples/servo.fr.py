# Un servo au connecteur S1
# Une pince y est fixée : 30 est ouvert, 90 est fermé.
# callibot n'a pas de commande pour les servos :
# le programme envoie lui-même les octets.
from callibot import *

OPEN = 30
CLOSED = 90


def set_servo(angle):
    # 0x14 est S1, 0x15 est S2 ; l'angle va de 0 à 180
    i2c.write(0x20, bytes([0x14, angle]))


for turn in range(3):
    set_servo(OPEN)
    delay(1000)
    set_servo(CLOSED)
    delay(1000)

for angle in range(CLOSED, OPEN, -5):   # ouvrir lentement
    set_servo(angle)
    delay(100)
