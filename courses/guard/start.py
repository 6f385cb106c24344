# Dodge the guard
# Task: get past the guard into the target. Whoever touches the guard has lost.
# Hint: it leaves the gate only while the robot is on its field. How far away do you lure it?
from mbrobot import *

setSpeed(50)

right()
delay(353)
forward()
delay(1500)
stop()
# You are on its field: here it comes!
while True:
    print(getDistance(), "cm")
    delay(200)
