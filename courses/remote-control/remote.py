# Remote control: button A drives, tilting turns.
from microbit import *
import radio

radio.on()
radio.config(channel=7)

while True:
    tilt = accelerometer.get_x()
    if tilt < -300:
        order = "left"
    elif tilt > 300:
        order = "right"
    elif button_a.is_pressed():
        order = "forward"
    else:
        order = "stop"
    radio.send(order)
    display.show(order[0])
    sleep(100)
