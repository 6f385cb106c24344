from $module import *

motL.rotate(66)
motR.rotate(100)
delay($arc)
stop()
