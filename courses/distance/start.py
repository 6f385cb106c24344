# Keep your distance
# Task: drive up to 10 cm from the wall and backwards to the start.
# getDistance() measures the distance ahead in centimetres.
from mbrobot import *

setSpeed(50)
forward()
delay(1000)
print(getDistance(), "cm")
# How does the robot go on as long as the distance is more than 10? Hint: while
stop()
