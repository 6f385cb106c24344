from $module import *

setSpeed(20)
forward()
delay(3000)
stop()
