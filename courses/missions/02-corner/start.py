from $module import *

forward()
delay($far)
stop()
# Go on here: turn left, then forward.
