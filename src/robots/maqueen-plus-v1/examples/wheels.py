# Exactly half a metre
# Each wheel counts: 80 pulses are one turn, that is 13.5 cm.
from microbit import i2c
from mbrobot_plus import *

ROBOT = 0x10
PULSES = 4              # the first register of the counters


def clear_pulses():
    i2c.write(ROBOT, bytes([PULSES, 0, 0, 0, 0]))


def left_pulses():
    i2c.write(ROBOT, bytes([PULSES]))
    high, low = i2c.read(ROBOT, 2)
    return high * 256 + low


goal = 50 / 13.5 * 80

clear_pulses()
setSpeed(20)            # when slow, the robot keeps its speed by itself
forward()
while left_pulses() < goal:
    delay(5)
stop()
print("Pulses:", left_pulses())
