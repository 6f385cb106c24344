# The device's module errno. This build of MicroPython knows the same numbers but one: 28, ENOSPC. It gets a name here, in
# the table that OSError takes its text from (MicroPython py/moderrno.c, py/obj.h: a map of pairs).
import struct as _struct
from _hal import board_micropython as _board_micropython
from errno import *
from uctypes import addressof as _addressof, bytearray_at as _bytearray_at

ENOSPC = 28

_WORD = 4
_USED_AND_FLAGS = 4
_SIZE = 8
_TABLE = 12


def _name_it():
    head = _bytearray_at(id(errorcode), 16)
    used, size, place = _struct.unpack_from("<III", head, _USED_AND_FLAGS)
    pair = _struct.pack("<II", ENOSPC << 1 | 1, id("ENOSPC"))
    table = bytes(_bytearray_at(place, 2 * _WORD * (used >> 3))) + pair
    # Three flags stand below the number of pairs.
    _struct.pack_into("<III", head, _USED_AND_FLAGS, used + (1 << 3), size + 1, _addressof(table))
    return table


_table = _name_it()
__name__ = "uerrno" if _board_micropython(1) < 19 else "errno"
