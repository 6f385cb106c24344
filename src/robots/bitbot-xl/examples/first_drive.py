# First drive
# Forward, a turn on the spot, a curve. Change the numbers and see what happens!
from mbbitbot import *

setSpeed(25)

for side in range(3):
    fill(0, 40, 0)          # green: it drives
    forward()
    sleep(800)
    fill(40, 20, 0)         # orange: it turns
    right()                 # this library's right() turns to the left
    sleep(300)
    stop()
    sleep(300)

leftArc(1)                  # the left wheel at half the power
sleep(1500)
stop()
fill(0, 0, 0)
