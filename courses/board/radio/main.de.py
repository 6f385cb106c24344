# Nachrichten funken
# A funkt «Hallo», B funkt «Bis bald». Öffne den Funk und antworte.
from microbit import *
import radio

radio.config(group=7)         # nur Geräte der gleichen Gruppe hören sich
radio.on()
display.show(Image.TARGET)

while True:
    if button_a.was_pressed():
        radio.send('Hallo')
    if button_b.was_pressed():
        radio.send('Bis bald')
    message = radio.receive()
    if message:
        print('Empfangen:', message)
        display.scroll(message)
        display.show(Image.TARGET)
    sleep(20)
