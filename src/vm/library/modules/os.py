# The device's module os, over the board's flat file system. Errors: MicroPython microbitfs.c.
import _hal as _h
from collections import namedtuple as _namedtuple

_ENOENT = 2
_FIELDS = ("sysname", "nodename", "release", "version", "machine")
# The device shows it without a name: (sysname='microbit', …).
uname_result = _namedtuple("", _FIELDS)  # named for type hints alone: the device has no name for it
_uname = uname_result(*[_h.board_text(field) for field in _FIELDS])


def listdir():
    names = []
    name = _h.file_name(0)
    while name is not None:
        names.append(name)
        name = _h.file_name(len(names))
    return names


def ilistdir():
    return iter([(name, 0x8000, 0) for name in listdir()])


def remove(filename):
    if _h.file_remove(_name(filename)):
        raise OSError(_ENOENT)


def size(filename):
    n = _h.file_size(_name(filename))
    if n < 0:
        raise OSError(_ENOENT)
    return n


def stat(filename):
    return (0x8000, 0, 0, 0, 0, 0, size(filename), 0, 0, 0)


def uname():
    return _uname


def _name(filename):
    if isinstance(filename, str):
        return filename
    raise TypeError("can't convert '%s' object to str implicitly" % type(filename).__name__)
