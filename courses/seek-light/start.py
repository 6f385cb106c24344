# To the light
# Task: drive into the next room, under the lamp. It is dark, only the light shows you the way.
# Sensor 1 is on the left, sensor 2 on the right: 0 is dark, 1023 very bright.
from mbrobot_plusV3 import *

LEFT = 1
RIGHT = 2

setSpeed(50)
leftArc(0.1)            # half a circle: how do the two values change?
for i in range(10):
    print(readLightIntensity(LEFT), readLightIntensity(RIGHT))
    delay(300)
stop()
# To which side must the robot turn? And how does it notice that it is under the lamp?
