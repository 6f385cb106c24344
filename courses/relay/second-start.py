# The second runner waits. For what?
from callibot import *
import radio

radio.on()
radio.config(channel=12)

while True:
    message = radio.receive()
    if message is not None:
        print(message)
    delay(20)
