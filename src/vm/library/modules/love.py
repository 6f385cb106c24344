# A beating heart. Brightness and pace: micropython-microbit-v2 modlove.c.
from _sim import on_import as _on_import
from microbit import Image as _Image, display as _display, sleep as _sleep

_LEVELS = (0, 1 / 9, 2 / 9, 4 / 9, 6 / 9, 7 / 9, 1)
_STEP_MS = 25
_PAUSE_MS = 500


def badaboom():
    hearts = [_Image.HEART * level for level in _LEVELS]
    for beat in range(8):
        if beat and beat % 2 == 0:
            _sleep(_PAUSE_MS)
        for heart in hearts + hearts[::-1]:
            _display.show(heart)
            _sleep(_STEP_MS)
    _display.clear()


_on_import["love"] = badaboom
