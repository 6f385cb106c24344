# Hide and seek: the stronger the signal, the nearer the other one.
from mbrobot import *
import radio

radio.on()
radio.config(channel=30)

def strength():
    """How strong the other one is heard now, in dBm: -50 after a metre, more when it is nearer."""
    while radio.receive() is not None:
        pass            # old messages
    message = None
    while message is None:
        delay(10)
        message = radio.receive_full()
    return message[1]

def drive(movement, milliseconds):
    movement()
    delay(milliseconds)
    stop()

setSpeed(50)
before = strength()

while before < -38:     # farther than 25 cm
    if getDistance() < 12:
        drive(backward, 300)
        drive(left, 400)
    drive(forward, 400)
    now = strength()
    print(now)
    if now < before:    # colder: turn
        drive(left, 450)
    before = now

setSpeed(25)
left()                  # it must be near: where?
while getDistance() > 25:
    delay(20)
forward()
delay(3000)             # until it is touched
stop()
