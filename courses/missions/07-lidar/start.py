from $module import *

setSpeed(50)
print(getDistance())
forward()
while getDistance() > 40:
    delay(20)
stop()
