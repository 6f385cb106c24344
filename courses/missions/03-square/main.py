from $module import *

for i in range(4):
    forward()
    delay($side)
    left()
    delay($quarter)
stop()
