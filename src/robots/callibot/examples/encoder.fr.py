# Exactement un demi-mètre
# Les roues du Calli:bot 2E comptent :
# 450 impulsions font un tour, soit 14,3 cm.
from callibot import *

PULSES_PER_CM = 31.48


def pulses():
    # Registre 0x91 : quatre octets pour la roue gauche, quatre pour la droite
    i2c.write(0x22, bytes([0x91]))
    answer = i2c.read(0x22, 9)
    return int.from_bytes(answer[1:5], "little")


def drive(cm):
    i2c.write(0x22, bytes([5, 3]))      # les deux compteurs à 0
    forward()
    while pulses() < cm * PULSES_PER_CM:
        delay(5)
    stop()


setSpeed(30)
drive(50)
delay(500)
print("Parcouru : %.1f cm" % (pulses() / PULSES_PER_CM))
