# Genau einen halben Meter
# Die Räder des Calli:bot 2E zählen mit:
# 450 Pulse sind eine Umdrehung, also 14.3 cm.
from callibot import *

PULSES_PER_CM = 31.48


def pulses():
    # Register 0x91: vier Bytes für das linke Rad, vier für das rechte
    i2c.write(0x22, bytes([0x91]))
    answer = i2c.read(0x22, 9)
    return int.from_bytes(answer[1:5], "little")


def drive(cm):
    i2c.write(0x22, bytes([5, 3]))      # beide Zähler auf 0
    forward()
    while pulses() < cm * PULSES_PER_CM:
        delay(5)
    stop()


setSpeed(30)
drive(50)
delay(500)
print("Gefahren: %.1f cm" % (pulses() / PULSES_PER_CM))
