# The second robot waits at the bar until the first one says so.
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
forward()
while getDistance() > 5:
    delay(10)
stop()
while radio.receive() != "push":
    delay(5)
drive_to_line()
