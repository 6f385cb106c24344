from $module import *

forward()
while getDistance() > 15:
    delay(20)
backward()
delay($back)
stop()
