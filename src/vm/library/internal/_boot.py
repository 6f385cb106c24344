# Starts the device, runs the pupil's program, and hands over to the REPL. Not to be imported by programs.
import __main__
import gc
import sys
from uctypes import addressof

import _hal

_scope = __main__.__dict__
_file_size = _hal.file_size
_raw = _hal.repl_raw
_finish = _hal.finish
_shown = _hal.shown
_shown_skip = _hal.shown_skip
_stop_timers = _hal.run_every_stop
_give_reserve = _hal.reserve_give
_hold_reserve = _hal.reserve_hold
_report_begin = _hal.report_begin
_report_end = _hal.report_end
_reboot = _hal.reboot


def run():
    """Runs main.py, reports to the simulation how it ended, and lets the REPL answer until the board restarts."""
    gc.collect()
    _seal()
    # The names of the program get a table of their own, in its part of the heap.
    name = _scope["__name__"]
    _scope.clear()
    _scope["__name__"] = name
    _reserve(addressof(bytearray(_reserve_bytes)))
    gc.collect()
    failure = None
    try:
        try:
            if _raw():
                # A tool talks to the board: it wants to be alone.
                pass
            elif _file_size("main.py") >= 0:
                execfile("main.py", _scope)
            else:
                exec("from " + _module + " import *", _scope)
        except SystemExit as end:
            failure = _repl.cause(end)
        except BaseException as error:
            failure = error
        _stop_callbacks()
        _micropython._free()
        if failure is not None:
            _report(failure)
    except BaseException as error:
        # An interrupt that came when main.py had ended already.
        _stop_callbacks()
        _micropython._free()
        _report(error)
    failure = None
    gc.collect()
    try:
        _finish()
        while not _shown():
            pass
    except BaseException:
        # Ctrl-C: enough of the error on the display.
        _shown_skip()
    _repl.serve()
    _reboot()


def _stop_callbacks():
    _stop_timers()
    _sim.forget()


def _report(error):
    _give_reserve()
    _report_begin()
    sys.print_exception(error)
    try:
        text = str(error)
    except BaseException:
        text = ""
    _report_end(type(error).__name__, text)
    _hold_reserve()


# Everything a program may import is loaded now, into the library's part of the heap: from the library alone, no file of
# the user's that has such a name.
sys.path[:] = ["/lib"]
import _sim
import _errno
import _gc
import _micropython
import _repl
import antigravity
import audio
import log
import love
import machine
import microbit

gc.collect()  # what importing leaves behind must not push the library into the program's part
import music
import neopixel
import os
import power
import radio
import speech
import this
import time

gc.collect()

_hal.image_type(id(microbit.Image))
# The device collects when its memory is full; this build would every 16 kB.
gc.threshold(-1)
_module = _hal.board_module(0)
_seal = _hal.seal
_reserve = _hal.reserve
_reserve_bytes = _hal.reserve_bytes()
_booted = _hal.booted
import _import

sys.path[:] = ["", "/lib"]
for _module_of_ours in sys.modules.values():
    _sim.seal_types(_module_of_ours)
    # Built in, as far as a program can see.
    if hasattr(_module_of_ours, "__file__"):
        del _module_of_ours.__file__
# Only the library may reach the board, and only the runner may call what could break it. What the library consists of
# is no module of the device's.
for _name in list(sys.modules):
    if _name[0] == "_" and _name != "__main__":
        del sys.modules[_name]
_booted()
