# A servo at port S1
# A claw hangs on it: 30 is open, 90 is closed.
# callibot has no command for servos:
# the program sends the bytes itself.
from callibot import *

OPEN = 30
CLOSED = 90


def set_servo(angle):
    # 0x14 is S1, 0x15 is S2; the angle goes from 0 to 180
    i2c.write(0x20, bytes([0x14, angle]))


for turn in range(3):
    set_servo(OPEN)
    delay(1000)
    set_servo(CLOSED)
    delay(1000)

for angle in range(CLOSED, OPEN, -5):   # open slowly
    set_servo(angle)
    delay(100)
