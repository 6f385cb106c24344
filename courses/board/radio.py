# Messages by radio
# A sends "Hello", B sends "See you". Open the radio and answer.
from microbit import *
import radio

radio.config(group=7)         # only devices of the same group hear each other
radio.on()
display.show(Image.TARGET)

while True:
    if button_a.was_pressed():
        radio.send('Hello')
    if button_b.was_pressed():
        radio.send('See you')
    message = radio.receive()
    if message:
        print('Received:', message)
        display.scroll(message)
        display.show(Image.TARGET)
    sleep(20)
