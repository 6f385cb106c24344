# Genau einen halben Meter
# Jedes Rad zählt mit: 80 Pulse sind eine Umdrehung, also 13.5 cm.
from microbit import i2c
from mbrobot_plus import *

ROBOT = 0x10
PULSES = 4              # das erste Register der Zähler


def clear_pulses():
    i2c.write(ROBOT, bytes([PULSES, 0, 0, 0, 0]))


def left_pulses():
    i2c.write(ROBOT, bytes([PULSES]))
    high, low = i2c.read(ROBOT, 2)
    return high * 256 + low


goal = 50 / 13.5 * 80

clear_pulses()
setSpeed(20)            # langsam hält der Roboter sein Tempo selbst
forward()
while left_pulses() < goal:
    delay(5)
stop()
print("Pulse:", left_pulses())
