# Two traffic lights
# In the light of the red lamp the display measures more than RED. Then the robot waits at the stop line.
from mbrobot_plusV2 import *
from microbit import display

RED = 140

def is_dark(sensor):
    return sensor.read_digital() == 0

def follow_line():
    """Along the line, until the outer sensors see a stop line."""
    while not (is_dark(irL2) or is_dark(irR2)):
        if is_dark(irL1) and not is_dark(irR1):
            leftArc(0.2)
        elif is_dark(irR1) and not is_dark(irL1):
            rightArc(0.2)
        else:
            forward()
        delay(10)
    stop()

setSpeed(60)
display.read_light_level()      # the first measurement takes a moment
for light in range(2):
    follow_line()
    fillRGB(80, 0, 0)
    while display.read_light_level() > RED:
        delay(20)
    fillRGB(0, 80, 0)
    forward()                   # over the stop line
    delay(500)
follow_line()
clearRGB()
