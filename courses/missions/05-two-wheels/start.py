from $module import *

motL.rotate(85)
motR.rotate(100)
delay(1500)
stop()
