from $module import *

forward()
delay($side)
left()
delay($quarter)
stop()
