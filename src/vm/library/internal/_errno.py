# The device's module errno: the names of mpconfigport.h (MICROPY_PY_ERRNO_LIST). This build of MicroPython knows the same
# numbers but one, 28, and six more. The table that OSError takes its text from (MicroPython py/moderrno.c, py/obj.h: a map
# of pairs) becomes the device's.
import struct as _struct
from _hal import board_micropython as _board_micropython
from errno import *
from uctypes import addressof as _addressof, bytearray_at as _bytearray_at

del EADDRINUSE, ECONNABORTED, ECONNRESET, ENOBUFS, ECONNREFUSED, EHOSTUNREACH
ENOSPC = 28

_PAIR = 8
_USED_AND_FLAGS = 4
_FLAGS = 7


def _name_them():
    known = globals().values()
    head = _bytearray_at(id(errorcode), 16)
    used, _, place = _struct.unpack_from("<III", head, _USED_AND_FLAGS)
    table = b""
    for at in range(place, place + _PAIR * (used >> 3), _PAIR):
        pair = bytes(_bytearray_at(at, _PAIR))
        number = _struct.unpack("<I", pair)[0] >> 1
        if number in known:
            table += pair
        if number == EINVAL:
            table += _struct.pack("<II", ENOSPC << 1 | 1, id("ENOSPC"))
    size = len(table) // _PAIR
    _struct.pack_into("<III", head, _USED_AND_FLAGS, size << 3 | used & _FLAGS, size, _addressof(table))
    return table


_table = _name_them()
__name__ = "uerrno" if _board_micropython(1) < 19 else "errno"
