from $module import *

while True:
    if getDistance() < 15:
        left()
        delay($quarter)
    else:
        forward()
    delay(20)
