from $module import *

forward()
delay($far)
left()
delay($quarter)
forward()
delay($up)
stop()
