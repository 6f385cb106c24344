# Shared by the library's modules: buffer addresses, checks, callbacks.
# Loaded first, while every built-in module can still be imported (see _import.py).
import _hal
from math import trunc
from uctypes import addressof, bytearray_at
from utime import ticks_add, ticks_diff

_throw = _hal.throw
_retype = _hal.retype
_callbacks = []
_thrown = None


def raw(buffer):
    """The bytes of any object with a buffer, as bytes or bytearray."""
    if isinstance(buffer, str):
        return buffer.encode()
    return bytes(memoryview(buffer))


def part(buffer, first, count):
    """The bytes that a write takes, as a stream of the device: of all, the first ones, or so many from a place on."""
    data = raw(buffer)
    if first is None:
        return data
    # In C these are lengths without a sign.
    ints(first)
    if count is None:
        return data[: first & 0xFFFFFFFF]
    ints(count)
    first &= 0xFFFFFFFF
    return data[first : first + (count & 0xFFFFFFFF)]


def room(buffer):
    """The bytes of a buffer that a call fills, to be changed in place."""
    try:
        if isinstance(buffer, memoryview):
            # One of bytes that must not change raises a TypeError here.
            buffer[:0] = buffer[:0]
        changes = not isinstance(buffer, (str, bytes))
    except TypeError:
        changes = False
    if not changes:
        raise TypeError("object with buffer protocol required")
    return bytearray_at(addressof(buffer), len(bytes(memoryview(buffer))))


# Sets an attribute of an object of the library.
put = object.__setattr__
_types = set()


def refuse_attribute(thing, name, value):
    """Raises the device's error when a program sets an attribute of one of its objects: as their __setattr__."""
    if type(thing) in _types:
        raise AttributeError("'%s' object has no attribute '%s'" % (type(thing).__name__, name))
    # Of a class of the program's own, which is built on one of the library's.
    put(thing, name, value)


# py/obj.h, mp_obj_type_t: the place of a type's names among its slots, and the slots; mp_obj_dict_t: the map's flags.
_PLACE_OF_NAMES = 19
_SLOTS = 20
_FLAGS = 4
_IS_FIXED = 2


def seal_types(module):
    """On the device types lie in flash memory: from now on nobody changes what these have."""
    # One of these modules is the simulation itself, which has no such table.
    for value in getattr(module, "__dict__", {}).values():
        kind = value if isinstance(value, type) else type(value)
        if kind not in _types and getattr(kind, "__setattr__", None) is refuse_attribute:
            _types.add(kind)
            place = bytearray_at(id(kind) + _PLACE_OF_NAMES, 1)[0]
            names = word_at(id(kind) + _SLOTS + 4 * (place - 1))
            bytearray_at(names + _FLAGS, 1)[0] |= _IS_FIXED


def word_at(address):
    a, b, c, d = bytearray_at(address, 4)
    return a | b << 8 | c << 16 | d << 24


def put_word(address, word):
    word &= 0xFFFFFFFF
    bytearray_at(address, 4)[:] = bytes((word & 255, word >> 8 & 255, word >> 16 & 255, word >> 24))


def ints(*values):
    """Raises the device's TypeError for the first value that is not a whole number."""
    for value in values:
        range(value)


def number(value):
    """Raises the device's TypeError for anything but an integer or a float."""
    trunc(value)


def text(value):
    """The text of a str or of bytes, which the device takes alike; its TypeError for anything else."""
    if isinstance(value, str):
        return value
    if isinstance(value, bytes):
        return "".join([chr(byte if byte < 0x80 else 0x3F) for byte in value])
    return "".find(value)


def unchecked_text(data):
    """The str of new bytes, which it becomes; nobody looks whether they are UTF-8."""
    if not data:
        return ""
    _retype(id(data), id(str))
    return data


# Actions on the first import of a module of the device, by its name.
on_import = {}


def raise_in_program(error):
    """Raises this error in the main program; it is kept here until then."""
    global _thrown
    _thrown = error
    _throw(id(error))


def remember(callback):
    """The number under which the simulation calls this function."""
    _callbacks.append(callback)
    return len(_callbacks) - 1


def forget():
    """Those that are queued already do not run any more."""
    for number in range(len(_callbacks)):
        _callbacks[number] = None


def _dispatch(number):
    global _thrown
    callback = _callbacks[number]
    if not callback:
        return
    try:
        callback()
    except BaseException as error:
        # Its last call. The main program ends with it: micropython-microbit-v2 modmicrobit.c, run_every.
        # Kept here, so that it is not collected before it is raised there.
        _callbacks[number] = None
        _thrown = error
        try:
            _thrown = SystemExit(None, error)
        except MemoryError:
            # Then it ends the program as it is.
            pass
        _throw(id(_thrown))


_hal.on_callback(id(_dispatch))
