# Push the block
# When the line sensors see the black line, the block in front of the robot is in the field already.
from mbrobot import *

setSpeed(50)

forward()
while irLeft.read_digital() == 1 and irRight.read_digital() == 1:
    delay(10)
stop()
delay(300)

backward()              # the block stays where it is
delay(1000)
stop()
fillRGB(0, 80, 0)       # done!
