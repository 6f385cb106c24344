from $module import *

leftArc(0.5)
delay(1500)
stop()
