# Starts the device and runs the pupil's program. Not to be imported by programs.
import __main__
import gc
import sys
from uctypes import addressof

import _hal

_scope = __main__.__dict__
# Room for errors when the heap is full: given free when memory runs out, or when the program has failed otherwise.
_reserve = bytearray(4096)
_hal.reserve(addressof(_reserve))


def run():
    """Runs main.py and tells the simulation how it ended."""
    global _reserve
    failure = None
    try:
        try:
            execfile("main.py", _scope)
        except SystemExit as end:
            # An error in a callback ends the program this way: _sim.py.
            if len(end.args) == 2 and isinstance(end.args[1], BaseException):
                failure = end.args[1]
        except BaseException as error:
            failure = error
        _hal.run_every_stop()
        if failure is not None:
            _hal.reserve(0)
            _reserve = None
            _report(failure)
            failure = None
        _scope.clear()
        gc.collect()
    except BaseException as error:
        # An interrupt that came when main.py had ended already.
        _report(error)
    _hal.finish()


def _report(error):
    _hal.report_begin()
    sys.print_exception(error)
    try:
        text = str(error)
    except BaseException:
        text = ""
    _hal.report_end(type(error).__name__, text)


def _fill(start):
    """Fills what the library left free below `start`, so that every program finds the same empty heap above it."""
    filling = None
    size = 8192
    while size >= 16:
        block = [filling, bytearray(size)]
        if max(addressof(block[1]) + size, id(block)) < start:
            filling = block
        else:
            # Too large for what is left: give it back first, or it would be in the way of smaller ones.
            block = None
            gc.collect()
            size //= 2
    return filling


# Everything a program may import is loaded now, into the library's part of the heap: from the library alone, no file of
# the user's that has such a name.
sys.path[:] = ["/lib"]
import _sim
import audio
import log
import machine
import microbit
import music
import neopixel
import os
import power
import radio
import speech
import time

_hal_start = _hal.program_start()
import _import

sys.path[:] = ["", "/lib"]
# The way to the board is the library's alone.
del sys.modules["_hal"]
gc.collect()
_filling = _fill(_hal_start)
gc.collect()
