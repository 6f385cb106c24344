# A claw
# It hangs on the servo at port S1: 30 is open, 90 is closed.
# Under “Device” you choose something else.
from microbit import *
from cutebot import *

OPEN = 30
CLOSED = 90

for turn in range(3):
    set_servo_1_angle(OPEN)
    sleep(1000)
    set_servo_1_angle(CLOSED)
    sleep(1000)

for angle in range(CLOSED, OPEN, -5):   # open slowly
    set_servo_1_angle(angle)
    sleep(100)
