# cbalarm.py: alarm sounds, to go with the libraries of the Calli:bot.
# Names and sounds are those of the school library of that name (Tiger-Jython); the code is our own.

import music


def setAlarm(on):
    """Two tones and a pause again and again in the background: 1 on, 0 off."""
    if on:
        music.play(["c6:1", "r", "c6:1", "r", "r", "r"], wait=False, loop=True)
    else:
        music.stop()


def beep():
    music.pitch(2000, 200, wait=False)
