# Time is simulated time: the clock of the run, not the wall's.
import _hal as _h
from _sim import ints as _ints, number as _number, ticks_add, ticks_diff

_sleep_ms = _h.sleep_ms
_sleep_s = _h.sleep_s
_sleep_us = _h.sleep_us
_sleep_until = _h.sleep_until
_ticks_ms = _h.ticks_ms
_ticks_us = _h.ticks_us


def _rest(t):
    # A callback came in between: sleep on until the same moment.
    while t:
        t = _sleep_until(t)


def sleep(seconds):
    t = _sleep_s(seconds)
    if t:
        _number(seconds)
        _rest(t)


def sleep_ms(ms):
    _ints(ms)
    t = _sleep_ms(ms)
    if t:
        _rest(t)


def sleep_us(us):
    _ints(us)
    _sleep_us(us)


def ticks_ms():
    return _ticks_ms()


def ticks_us():
    return _ticks_us()
