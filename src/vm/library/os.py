# The device's module os, over the board's flat file system. Errors: MicroPython microbitfs.c.
import _hal as _h

_ENOENT = 2


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
    from collections import namedtuple

    return namedtuple("uname_result", ("sysname", "nodename", "release", "version", "machine"))(
        "microbit",
        "microbit",
        "2.1.2",
        "micro:bit v2.1.2+0697c6d on 2023-10-30; MicroPython v1.18 on 2023-10-30",
        "micro:bit with nRF52833",
    )


def _name(filename):
    if isinstance(filename, str):
        return filename
    raise TypeError("can't convert '%s' object to str implicitly" % type(filename).__name__)
