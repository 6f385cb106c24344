from $module import *

forward()
delay(1000)
stop()
