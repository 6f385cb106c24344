from $module import *

setSpeed(40)
while True:
    if irLeft.read_digital() == 0 and irRight.read_digital() == 0:
        forward()
    elif irLeft.read_digital() == 0:
        leftArc(0.06)
    elif irRight.read_digital() == 0:
        rightArc(0.06)
    delay(10)
