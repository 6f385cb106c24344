# Esattamente mezzo metro
# Ogni ruota conta: 80 impulsi sono un giro, cioè 13.5 cm.
from microbit import i2c
from mbrobot_plus import *

ROBOT = 0x10
PULSES = 4              # il primo registro dei contatori


def clear_pulses():
    i2c.write(ROBOT, bytes([PULSES, 0, 0, 0, 0]))


def left_pulses():
    i2c.write(ROBOT, bytes([PULSES]))
    high, low = i2c.read(ROBOT, 2)
    return high * 256 + low


goal = 50 / 13.5 * 80

clear_pulses()
setSpeed(20)            # quando va piano il robot tiene da sé la velocità
forward()
while left_pulses() < goal:
    delay(5)
stop()
print("Impulsi:", left_pulses())
