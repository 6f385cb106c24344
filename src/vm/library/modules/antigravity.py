# The picture on the display rises, one row every 200 ms: micropython-microbit-v2 modantigravity.c. The drawing is ours.
from _sim import on_import as _on_import
from microbit import display as _display, sleep as _sleep

_STEP_MS = 200
_DRAWING = r"""
          \o/   MicroPython!
          /|
           |\
    ^  ^  ^
      o   How do you fly?
     /|\
     / \
"""


def __init__():
    print(_DRAWING)
    for step in range(5):
        _sleep(_STEP_MS)
        for y in range(1, 5 - step):
            for x in range(5):
                light = _display.get_pixel(x, y)
                if light and not _display.get_pixel(x, y - 1):
                    _display.set_pixel(x, y, 0)
                    _display.set_pixel(x, y - 1, light)


_on_import["antigravity"] = __init__
