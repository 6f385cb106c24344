from $module import *

setSpeed(40)
forward()
delay(1000)
stop()
# Follow the line all the way round.
