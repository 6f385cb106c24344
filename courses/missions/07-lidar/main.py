from $module import *

setSpeed(50)
print(getDistance())
forward()
while getDistance() > 15:
    delay(20)
backward()
delay($back)
stop()
