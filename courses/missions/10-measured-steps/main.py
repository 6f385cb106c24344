from $module import *

def step():
    pidControlDistance(1, 19, 1)
    pidControlAngle(-90, 1)
    pidControlDistance(1, 19, 1)
    pidControlAngle(90, 1)

for i in range(2):
    step()
