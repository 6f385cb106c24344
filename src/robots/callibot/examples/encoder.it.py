# Esattamente mezzo metro
# Le ruote del Calli:bot 2E contano:
# 450 impulsi sono un giro, cioè 14.3 cm.
from callibot import *

PULSES_PER_CM = 31.48


def pulses():
    # Registro 0x91: quattro byte per la ruota sinistra, quattro per la destra
    i2c.write(0x22, bytes([0x91]))
    answer = i2c.read(0x22, 9)
    return int.from_bytes(answer[1:5], "little")


def drive(cm):
    i2c.write(0x22, bytes([5, 3]))      # tutti e due i contatori a 0
    forward()
    while pulses() < cm * PULSES_PER_CM:
        delay(5)
    stop()


setSpeed(30)
drive(50)
delay(500)
print("Percorso: %.1f cm" % (pulses() / PULSES_PER_CM))
