# The robot does what it hears. The road helps: it stays on the line, and turns up to the next one.
from mbrobot import *
from microbit import running_time
import radio

radio.on()
radio.config(channel=7)
setSpeed(30)

def is_dark(sensor):
    return sensor.read_digital() == 0

order = "stop"
begun = 0       # when the order came
on_line = 0     # when a sensor was last on the line
while True:
    heard = radio.receive()
    if heard is not None and heard != order:
        order = heard
        begun = on_line = running_time()
    left_dark, right_dark = is_dark(irLeft), is_dark(irRight)
    if left_dark or right_dark:
        on_line = running_time()
    if order == "forward":
        if left_dark and not right_dark:
            left()
        elif right_dark and not left_dark:
            right()
        elif running_time() - on_line < 300:
            forward()
        else:
            stop()      # the line has ended
    elif order == "stop" or running_time() - begun > 300 and (left_dark or right_dark):
        stop()
    elif order == "left":
        left()
    elif order == "right":
        right()
    delay(5)
