# Avoid obstacles
# The ultrasonic sensor measures the distance straight ahead, in centimetres.
# It looks like the beam of a torch: what stands beside the beam stays unseen.
# So where the way ends, the robot also looks to the left and to the right.
from mbrobot import *

NEAR = 25               # centimetres: closer than this it does not go
FREE = 50               # centimetres: so far ahead the new way should be free
LOOK = 110              # milliseconds of turning for a look to the side

def turn(direction):
    direction()         # left or right
    delay(LOOK)
    stop()
    delay(40)           # stand still, then measure

def look(direction, back):
    """Distance beside the robot; afterwards it looks ahead again."""
    turn(direction)
    distance = getDistance()
    turn(back)
    return distance

def is_free(far):
    return getDistance() > far and look(left, right) > NEAR and look(right, left) > NEAR

setSpeed(50)

while True:
    setLED(0)
    forward()
    while getDistance() > NEAR:
        delay(20)
    stop()

    setLED(1)
    direction = left if look(left, right) > look(right, left) else right
    turn(direction)
    far = FREE
    while not is_free(far):
        turn(direction)     # always the same way round, or it would dither in a corner
        far = far - 3       # whoever searches long is content with less
