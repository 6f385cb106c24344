# To the light
# Two sensors measure how bright it is on the left and on the right. The robot always turns to the brighter side.
from mbrobot_plusV3 import *

LEFT = 1
RIGHT = 2
UNDER_LAMP = 900        # nowhere else is it so bright

setSpeed(50)
while True:
    left_light = readLightIntensity(LEFT)
    right_light = readLightIntensity(RIGHT)
    if min(left_light, right_light) > UNDER_LAMP:
        break
    if left_light > right_light + 8:
        leftArc(0.1)
    elif right_light > left_light + 8:
        rightArc(0.1)
    else:
        forward()       # equally bright: the light is straight ahead
    delay(20)
stop()
fillRGB(80, 60, 0)      # found!
