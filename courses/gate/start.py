# The sliding gate
# Task: drive through the gate to the target without touching the sliding gate.
# Hint: at the stop line, measure with getDistance() whether the way is free.
from mbrobot import *

setSpeed(60)

forward()
while irLeft.read_digital() == 1:
    delay(5)
stop()
# You are at the stop line. What are you waiting for?
while True:
    print(getDistance(), "cm")
    delay(200)
