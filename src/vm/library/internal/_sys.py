# The device's view of sys.
import _hal
from collections import namedtuple
from sys import argv, byteorder, exit, maxsize, modules, path, print_exception

__name__ = "sys"
platform = "microbit"
version = _hal.board_text("sysVersion")
version_info = (3, 4, 0)
_micropython = tuple(_hal.board_micropython(part) for part in range(3))
if _micropython < (1, 22):
    implementation = namedtuple("", ("name", "version"))("micropython", _micropython)
else:
    # Since MicroPython 1.22: a fourth part, and the board.
    implementation = namedtuple("", ("name", "version", "_machine"))(
        "micropython", _micropython + ("",), _hal.board_text("banner").split("; ")[1]
    )
del namedtuple
