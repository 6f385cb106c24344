# Sort by colour
# The colour sensor in front says the colour, the claw on S1 carries: red to the left, blue to the right.
from mbrobot import *
import colour

OPEN = 30
CLOSED = 90

def is_dark(sensor):
    return sensor.read_digital() == 0

def follow_line():
    """Along the line to the next block, until it lies between the jaws."""
    while getDistance() > 4:
        if is_dark(irLeft) and is_dark(irRight):
            forward()
        elif is_dark(irLeft):
            leftArc(0.1)
        elif is_dark(irRight):
            rightArc(0.1)
        delay(5)        # beside the line the arc goes on
    stop()

def grab(angle):
    setServo("S1", angle)
    delay(600)

def put_away(there, back, sensor):
    """Turns away from the line, puts the block down in the zone and comes back onto the line."""
    there()             # left or right, a quarter turn
    delay(330)
    stop()
    delay(200)
    forward()
    delay(1000)
    stop()
    grab(OPEN)
    backward()
    while not is_dark(sensor):
        delay(5)
    forward()           # the wheels stand where the sensors were
    delay(300)
    back()
    delay(200)
    while not is_dark(sensor):
        delay(5)
    stop()

grab(OPEN)
for block in range(4):
    follow_line()
    grab(CLOSED)
    name = colour.name()
    print(name)
    if name == "red":
        fillRGB(80, 0, 0)
        put_away(left, right, irRight)
    else:
        fillRGB(0, 0, 80)
        put_away(right, left, irLeft)
stop()
clearRGB()
