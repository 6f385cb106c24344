# Pushes two blocks against a fixed one, turns away and drives along a slanting wall.
from mbrobot import *

setSpeed(60)
forward()
delay(3000)
backward()
delay(500)
right()
delay(250)
setSpeed(80)
forward()
delay(4000)
leftArc(0.2)
delay(3000)
stop()
