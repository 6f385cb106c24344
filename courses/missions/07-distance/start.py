from $module import *

forward()
while getDistance() > 40:
    delay(20)
stop()
