# My robot 4: line sensors
# Each press of button A shows what the line sensors read, from left to right.
from microbit import *
from mbrobot_plusV2 import *

SENSORS = [("L2", irL2), ("L1", irL1), ("M", irM), ("R1", irR1), ("R2", irR2)]
display.show(Image.ARROW_S)

while True:
    if button_a.was_pressed():
        for name, sensor in SENSORS:
            value = sensor.read_analog()
            print(name, value)
            display.scroll(name + " " + str(value))
        display.show(Image.ARROW_S)
    delay(20)
