# Looks about with the lidar in both its modes, drives by what it sees, turns by measure, and takes a crossing by itself.
from microbit import running_time
from mbrobot_plusV3 import *

setIntersectionRunMode(1)
setPatrolSpeed(3)
patrolling(1)
while intersectionDetecting() != 1:
    delay(20)
while intersectionDetecting() == 1:
    setLED(running_time() // 200 % 8)
patrolling(2)

setSpeed(45)
while running_time() < 20000:
    grid = getDistanceGrid()
    sums = [sum([min(row[x], 100) for row in grid]) for x in range(8)]
    low = min(grid[6])
    if low > 26:
        forward()
    elif sum(sums[:4]) > sum(sums[4:]):
        pidControlAngle(-(20 + low), 1)
    else:
        pidControlAngle(20 + low, 1)
    fillRGB(sums[0] // 4, sums[7] // 4, irM.read_analog() // 64)
stop()

setLidarMode(4)
while True:
    nearest = min(getDistanceList())
    motL.rotate(30 + nearest)
    motR.rotate(40 + getDistanceAt(0, 1) // 10)
    if nearest < 15:
        pidControlDistance(2, 5, 1)
    print(readRealTimeSpeed(1), readLightIntensity(2))
