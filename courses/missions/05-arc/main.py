from $module import *

leftArc(0.2)
delay($arc)
stop()
