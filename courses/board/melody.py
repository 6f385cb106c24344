# Melody
# A note: name, octave, length. 'C4:8' is middle C, 8 units long.
from microbit import *
import music

tune = ['C4:4', 'D4', 'E4', 'C4', 'C4', 'D4', 'E4', 'C4',
        'E4', 'F4', 'G4:8', 'E4:4', 'F4', 'G4:8']

display.show(Image.MUSIC_QUAVERS)
music.set_tempo(bpm=140)
music.play(tune)

display.show('A')             # button A: a ready melody
while True:
    if button_a.was_pressed():
        music.play(music.NYAN, wait=False)
    if button_b.was_pressed():
        music.stop()
    sleep(20)
