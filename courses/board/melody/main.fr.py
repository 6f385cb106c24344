# Mélodie
# Une note : nom, octave, durée. 'C4:8' est le do du milieu, long de 8 unités.
from microbit import *
import music

tune = ['C4:4', 'D4', 'E4', 'C4', 'C4', 'D4', 'E4', 'C4',
        'E4', 'F4', 'G4:8', 'E4:4', 'F4', 'G4:8']

display.show(Image.MUSIC_QUAVERS)
music.set_tempo(bpm=140)
music.play(tune)

display.show('A')             # bouton A : une mélodie toute prête
while True:
    if button_a.was_pressed():
        music.play(music.NYAN, wait=False)
    if button_b.was_pressed():
        music.stop()
    sleep(20)
