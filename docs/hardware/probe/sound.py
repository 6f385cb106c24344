# Probe: how long sounds are. Prints ms; it takes two minutes and can be heard. See README.md beside this file.
import os, gc, time
try:
    from microbit import *
except ImportError:
    from calliopemini import *


def row(id, unit, value):
    print("probe;row;%s;%s;%s" % (unit, id, value))
    rows.append(0)


rows = []

import music, audio, speech

SOUNDS = (
    "music.pitch(440, 200)", "music.play('c4:4')", "music.play('c4:1')", "music.play(['c4:4', 'd', 'e', 'r'])",
    "music.play(music.DADADADUM)", "music.play(music.BA_DING)", "music.play(music.JUMP_UP)",
    "music.play(music.POWER_DOWN)", "music.play(music.WAWAWAWAA)", "audio.play(Sound.GIGGLE)",
    "audio.play(Sound.HAPPY)", "audio.play(Sound.HELLO)", "audio.play(Sound.MYSTERIOUS)", "audio.play(Sound.SAD)",
    "audio.play(Sound.SLIDE)", "audio.play(Sound.SOARING)", "audio.play(Sound.SPRING)", "audio.play(Sound.TWINKLE)",
    "audio.play(Sound.YAWN)", "audio.play(audio.SoundEffect())", "audio.play(audio.SoundEffect(duration=1000))",
    "speech.say('hello')", "speech.say('I am a robot')", "speech.say('hello', speed=100)",
    "speech.pronounce('/HEHLOW')", "display.scroll('Hello')", "display.show('Hello')", "display.scroll(12.5)",
    "display.scroll('Hello', delay=50)",
)

print("probe;begin;sound;1;%s" % os.uname().machine)
for sound in SOUNDS:
    try:
        before = time.ticks_ms()
        eval(sound)
        row(sound, "ms", time.ticks_diff(time.ticks_ms(), before))
    except Exception as problem:
        row(sound, "text", repr(problem))
    sleep(200)
print("probe;end;sound;%d" % len(rows))
