# Push the block
# Task: push the block into the target field, all of it.
# The black line tells you when it is enough: irLeft.read_digital() is then 0.
from mbrobot import *

setSpeed(50)

forward()
delay(2000)
stop()
# How does the robot drive just as far as the line?
