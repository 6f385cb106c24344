# The tunnel
# In the light the robot follows the line. In the dark it drives up to the next wall and turns until the way is free.
from mbrobot import *
from microbit import display

DARK = 40               # in the tunnel the display measures less
NEAR = 6                # centimetres up to the wall
FAR = 25                # centimetres from which the way is free

def is_dark(sensor):
    return sensor.read_digital() == 0

def is_in_tunnel():
    return display.read_light_level() < DARK

def is_free():
    """True if nothing is near ahead. It listens twice, as an echo may be missed."""
    return getDistance() > FAR and getDistance() > FAR

def follow_line():
    if is_dark(irLeft) and is_dark(irRight):
        forward()
    elif is_dark(irLeft):
        leftArc(0.2)
    elif is_dark(irRight):
        rightArc(0.2)
    delay(5)            # beside the line the arc goes on

display.read_light_level()
delay(100)              # the first measurement takes a moment
forward()
while not is_in_tunnel():
    follow_line()

setLED(1)               # headlights on
for turn in (left, right):     # first to the left, then to the right
    forward()
    while getDistance() > NEAR:
        delay(5)
    turn()
    while not is_free():
        delay(5)
    stop()
    delay(300)

forward()               # out of the tunnel
while is_in_tunnel():
    delay(20)
setLED(0)
while not (is_dark(irLeft) or is_dark(irRight)):
    delay(5)
stop()
