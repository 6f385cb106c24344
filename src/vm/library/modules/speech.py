# The module speech. Names, settings and errors: micropython-microbit-v2 modspeech.c. The voice is our own: docs/decisions/0010.
import _hal as _h
from _audio import DEFAULT_PIN as _DEFAULT_PIN, check as _check, output as _output
from _sim import ints as _ints, text as _text

_LONGEST = 80


def translate(words):
    words = _text(words)
    if len(words.encode()) > _LONGEST:
        raise ValueError("text too long")
    phonemes = _h.speech_translate(words)
    if phonemes is None:
        raise ValueError("could not parse input")
    return phonemes


def _articulate(sings, phonemes, pitch=64, speed=72, mouth=128, throat=128, debug=False, mode=1, volume=4, pin=_DEFAULT_PIN):
    _ints(pitch, speed, mouth, throat, mode, volume)
    phonemes = _text(phonemes)
    _check(_h.audio_pin(_output(pin)))
    settings = (pitch & 255) | (speed & 255) << 8 | (mouth & 255) << 16
    if not _h.speech_say(phonemes, settings, throat & 255, sings):
        raise ValueError("Phoneme not understood")
    try:
        while _h.speech_wait():
            pass
    except BaseException:
        _h.speech_stop()
        raise


def say(words, **settings):
    _articulate(False, translate(words), **settings)


def pronounce(phonemes, **settings):
    _articulate(False, phonemes, **settings)


def sing(phonemes, **settings):
    _articulate(True, phonemes, **settings)
