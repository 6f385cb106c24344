# Messaggi via radio
# A manda «Ciao», B manda «A presto». Apri la radio e rispondi.
from microbit import *
import radio

radio.config(group=7)         # si sentono solo i dispositivi dello stesso gruppo
radio.on()
display.show(Image.TARGET)

while True:
    if button_a.was_pressed():
        radio.send('Ciao')
    if button_b.was_pressed():
        radio.send('A presto')
    message = radio.receive()
    if message:
        print('Ricevuto:', message)
        display.scroll(message)
        display.show(Image.TARGET)
    sleep(20)
