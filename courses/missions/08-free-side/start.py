from $module import *

setSpeed(50)
print(getDistance())
while True:
    forward()
    while getDistance() > 20:
        delay(20)
    left()
    delay($quarter)
