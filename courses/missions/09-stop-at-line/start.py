from $module import *

forward()
while getDistance() > 50:
    delay(10)
stop()
