from $module import *

setSpeed(100)
forward()
delay($drive)
stop()
