from $module import *

forward()
delay($push)
backward()
delay($back)
stop()
