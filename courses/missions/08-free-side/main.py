from $module import *

setSpeed(50)
print(getDistance())
while True:
    forward()
    while getDistance() > 20:
        delay(20)
    if getDistanceAt(0, 3) > getDistanceAt(7, 3):
        left()
    else:
        right()
    delay($quarter)
