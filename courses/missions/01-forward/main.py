from $module import *

forward()
delay($drive)
stop()
