# Exactly half a metre
# The wheels of the Calli:bot 2E count:
# 450 pulses are one turn, that is 14.3 cm.
from callibot import *

PULSES_PER_CM = 31.48


def pulses():
    # Register 0x91: four bytes for the left wheel, four for the right
    i2c.write(0x22, bytes([0x91]))
    answer = i2c.read(0x22, 9)
    return int.from_bytes(answer[1:5], "little")


def drive(cm):
    i2c.write(0x22, bytes([5, 3]))      # both counters to 0
    forward()
    while pulses() < cm * PULSES_PER_CM:
        delay(5)
    stop()


setSpeed(30)
drive(50)
delay(500)
print("Driven: %.1f cm" % (pulses() / PULSES_PER_CM))
