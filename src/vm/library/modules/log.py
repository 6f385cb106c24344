# The module log. Behaviour and errors: micropython-microbit-v2 modlog.c, codal-microbit-v2 MicroBitLog.cpp.
import _hal as _h
from _sim import ints as _ints, on_import as _on_import, text as _text

MILLISECONDS = 1
SECONDS = 10
MINUTES = 600
HOURS = 36000
DAYS = 864000

_NONE = 0
_ENOSPC = 28


def _check(done):
    if not done:
        raise OSError(_ENOSPC)


def _row(pairs):
    row = []
    try:
        for key, value in pairs:
            key = _part(key)
            if isinstance(value, (int, float, bool)):
                value = str(value)
            row.append(key + _part(value))
    except TypeError:
        # What comes before the mistake stays begun.
        _h.log_row("".join(row), False)
        raise
    _check(_h.log_row("".join(row), True))


def _part(text):
    # In C a text ends at a zero.
    return _text(text).split("\0")[0] + "\0"


def set_labels(*labels, timestamp=SECONDS):
    if timestamp is None:
        timestamp = _NONE
    _ints(timestamp)
    _h.log_timestamp(timestamp)
    if labels:
        _row([(label, "") for label in labels])


def set_mirroring(serial):
    _h.log_mirror(bool(serial))


def delete(full=False):
    # The log is erased either way: a full erase only leaves nothing to be found in the flash memory.
    _h.log_delete()


def add(*args, **kwargs):
    if len(args) > 1:
        raise ValueError("too many arguments")
    if args:
        (kwargs,) = args
        if not isinstance(kwargs, dict):
            raise ValueError("expecting a dict")
    _row(kwargs.items())


def _begin():
    _h.log_timestamp(SECONDS)


_on_import["log"] = _begin
