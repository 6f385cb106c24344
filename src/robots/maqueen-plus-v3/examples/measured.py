# Drive a square to the centimetre
# The robot counts the turns of its wheels by itself.
from mbrobot_plusV3 import *

for i in range(4):
    setLED(i + 1)
    pidControlDistance(1, 30, 1)    # 1 is forward, 30 cm, wait until it is there
    pidControlAngle(90, 1)          # 90 degrees to the right, wait

setLED(0)
