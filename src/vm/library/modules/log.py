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
    for key, value in pairs:
        key = _text(key)
        if isinstance(value, (int, float, bool)):
            value = str(value)
        value = _text(value)
        row.append((key, value))
    _h.log_begin()
    for key, value in row:
        _h.log_put(key, value)
    _check(_h.log_end())


def set_labels(*labels, timestamp=SECONDS):
    if timestamp is None:
        timestamp = _NONE
    _ints(timestamp)
    if not _h.log_timestamp(timestamp):
        raise ValueError("invalid timestamp")
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
