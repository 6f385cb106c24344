# Push together: the first robot says when they start.
from mbrobot import *
import radio

radio.on()
radio.config(channel=20)

def drive_to_line():
    """Until the line is below; the bar is in the field then."""
    forward()
    while irLeft.read_digital() == 1 and irRight.read_digital() == 1:
        delay(5)
    stop()

setSpeed(70)
forward()               # up to the bar
while getDistance() > 5:
    delay(10)
stop()
delay(1000)             # the other one needs its time, too
radio.send("push")
drive_to_line()
