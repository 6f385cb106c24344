from $module import *

forward()
while irLeft.read_digital() == 1:
    delay(10)
backward()
delay($back)
stop()
