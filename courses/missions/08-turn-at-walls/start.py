from $module import *

while True:
    if getDistance() < 15:
        stop()
    else:
        forward()
    delay(20)
