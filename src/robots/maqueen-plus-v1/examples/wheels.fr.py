# Exactement un demi-mètre
# Chaque roue compte : 80 impulsions font un tour, soit 13,5 cm.
from microbit import i2c
from mbrobot_plus import *

ROBOT = 0x10
PULSES = 4              # le premier registre des compteurs


def clear_pulses():
    i2c.write(ROBOT, bytes([PULSES, 0, 0, 0, 0]))


def left_pulses():
    i2c.write(ROBOT, bytes([PULSES]))
    high, low = i2c.read(ROBOT, 2)
    return high * 256 + low


goal = 50 / 13.5 * 80

clear_pulses()
setSpeed(20)            # lentement, le robot garde lui-même sa vitesse
forward()
while left_pulses() < goal:
    delay(5)
stop()
print("Impulsions :", left_pulses())
