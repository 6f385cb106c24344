from $module import *

def step():
    forward()
    delay($side)
    left()
    delay($quarter)
    forward()
    delay($side)
    right()
    delay($quarter)

for i in range(2):
    step()
stop()
