from $module import *

forward()
delay(500)
stop()
