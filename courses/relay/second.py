# The second runner waits for the baton, then runs to the line in the target.
from callibot import *
import radio

radio.on()
radio.config(channel=12)

while radio.receive() != "go":
    delay(20)

setSpeed(50)
forward()
while irLeftValue() == 1 and irRightValue() == 1:
    delay(10)
stop()
