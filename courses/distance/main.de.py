# Abstand halten
# Der Roboter fährt, bis die Wand 10 cm entfernt ist, und merkt sich, wie lange er unterwegs war.
# Rückwärts braucht er gleich lange.
from microbit import running_time
from mbrobot import *

setSpeed(50)

start = running_time()
forward()
while getDistance() > 10:
    delay(10)
stop()
way = running_time() - start

beep()
print("Fahrzeit:", way, "ms")
delay(500)

backward()
delay(way)
stop()
