# The hider stands still. It sends a message ten times a second.
from calliopemini import *
import radio

radio.on()
radio.config(channel=30)

while True:
    radio.send("beep")
    sleep(100)
