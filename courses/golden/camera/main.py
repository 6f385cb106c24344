# A camera follows a line to its end, then tells what else it finds.
from mbrobot import *
from huskylens import *

camera = Huskylens()
camera.set_algorithm(Algorithm.LINE_TRACKING)
setSpeed(20)
while True:
    line = camera.get_one()
    if line is None:
        break
    middle = (line.x_tail + line.x_head) // 2
    if middle < 140:
        leftArc(0.12)
    elif middle > 180:
        rightArc(0.12)
    else:
        forward()
stop()
for algorithm in (Algorithm.COLOR_RECOGNITION, Algorithm.TAG_RECOGNITION):
    camera.set_algorithm(algorithm)
    right()
    for turn in range(40):
        for found in camera.get_all():
            print(turn, found)
        delay(50)
stop()
