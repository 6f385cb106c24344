from $module import *

def step():
    forward()
    delay($side)
    left()
    delay($quarter)
    stop()

step()
