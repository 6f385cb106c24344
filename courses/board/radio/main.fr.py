# Messages par radio
# A envoie « Salut », B envoie « A plus ». Ouvre la radio et réponds.
from microbit import *
import radio

radio.config(group=7)         # seuls les appareils du même groupe s'entendent
radio.on()
display.show(Image.TARGET)

while True:
    if button_a.was_pressed():
        radio.send('Salut')
    if button_b.was_pressed():
        radio.send('A plus')
    message = radio.receive()
    if message:
        print('Reçu :', message)
        display.scroll(message)
        display.show(Image.TARGET)
    sleep(20)
