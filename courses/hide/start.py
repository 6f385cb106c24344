# Task: find the hidden robot by its radio, and touch it.
from mbrobot import *
import radio

radio.on()
radio.config(channel=30)

setSpeed(50)
forward()
delay(500)
stop()

while True:
    message = radio.receive_full()
    if message is not None:
        text, strength, time = message
        print(strength)
    delay(200)
    # Drive somewhere else: does the number grow?
