# What a program can import: the device's modules, not those that only this build of MicroPython has.
# Loaded last, when the library has all it needs.
import builtins
import _hal
import _files
import _sys
import os

_file_size = _hal.file_size
_import_module = builtins.__import__
_HIDDEN = (
    " _asyncio asyncio binascii cmath cryptolib deflate framebuf hashlib heapq io js jsffi json marshal"
    " platform re select ssl socket uctypes vfs websocket zlib "
)
_ALIASES = {"sys": "_sys", "usys": "_sys", "utime": "time", "uos": "os"}


def _is_hidden(name):
    # A file of the user's may have such a name.
    top = name.split(".")[0]
    known = top[1:] if top[0] == "u" and top != "uctypes" else top
    return " " + known + " " in _HIDDEN and _file_size(top + ".py") < 0


def _import(name, globals=None, locals=None, names=None, level=0):
    if level == 0:
        if _is_hidden(name):
            raise ImportError("no module named '" + name + "'")
        name = _ALIASES.get(name, name)
    return _import_module(name, globals, locals, names, level)


def _make_way():
    """A file of the user's wins over a module of the library that is loaded already."""
    for file in os.listdir():
        if file.endswith(".py"):
            _sys.modules.pop(file[:-3], None)


_make_way()
builtins.__import__ = _import
