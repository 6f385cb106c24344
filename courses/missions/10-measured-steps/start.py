from $module import *

def step():
    pidControlDistance(1, 19, 1)
    pidControlAngle(-90, 1)

step()
