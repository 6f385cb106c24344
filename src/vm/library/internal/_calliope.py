# The module calliope_mini of the Calliope mini 1 and 2, on the Calliope mini 3: its module, and what only
# they had. Loaded on that board alone (microbit.py).
# Source: calliope-mini/calliope-mini-micropython, source/microbit (modmicrobit.cpp, calliopeled.cpp).
import _hal as _h
from _sim import ints as _ints, put as _put, refuse_attribute as _refuse_attribute
from microbit import *
from microbit import pin_A0_SCL, pin_A0_SDA, pin_A1_RX, pin_A1_TX, pin_RGB, ws2812_write as _write


class CalliopeLED:
    # The old boards have one RGB LED; here all three show its colour.
    __setattr__ = _refuse_attribute

    def __init__(self):
        _put(self, "_colors", [0, 0, 0])

    def __repr__(self):
        return "<CalliopeLED>"

    def _set(self, part, value):
        _ints(value)
        self._colors[part] = value & 0xFF
        red, green, blue = self._colors
        _write(pin_RGB, bytes((green, red, blue) * _h.board_rgb_count()))

    def set_red(self, value):
        self._set(0, value)

    def set_green(self, value):
        self._set(1, value)

    def set_blue(self, value):
        self._set(2, value)

    def set_colors(self, red, green, blue):
        _ints(red, green, blue)
        self._colors[0] = red & 0xFF
        self._colors[1] = green & 0xFF
        self._set(2, blue)

    def get_red(self):
        return self._colors[0]

    def get_green(self):
        return self._colors[1]

    def get_blue(self):
        return self._colors[2]

    def get_colors(self):
        return tuple(self._colors)

    def clear(self):
        self.set_colors(0, 0, 0)


led = CalliopeLED()
# The touch pads and the two Grove connectors by the names that the old boards print beside them.
p0 = c0 = pin0
p1 = c1 = pin1
p2 = c2 = pin2
p3 = c3 = pin3
c16 = pin_A1_RX
c17 = pin_A1_TX
c18 = pin20 = pin_A0_SDA
c19 = pin19 = pin_A0_SCL
del CalliopeLED
__name__ = "calliope_mini"
