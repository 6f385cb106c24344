# First drive
# A short way and a turn. Change the numbers and see what happens!
from microbit import sleep
from new_robot import *

setLED(1)
forward()
sleep(1000)
left()
sleep(400)
stop()
setLED(0)
print("light" if isLight() else "dark")
