# open() and input() of the device. Behaviour and errors: MicroPython microbitfs.c; input: lib/mp-readline.
import builtins
import _hal
from _sim import addressof, ints, part, put, refuse_attribute, room, text as as_text, unchecked_text

_open = _hal.file_open
_read = _hal.file_read
_write = _hal.file_write
_span = _hal.file_span
_line = _hal.serial_input
_BYTES = 0
_CHARACTERS = 1
_LINE = 2
_EBADF = 9
_CTRL_C = 3
_END_OF_INPUT = 4


class FileIO:
    # Open files live here alone: the board's file system keeps no list of them.
    __setattr__ = refuse_attribute

    def __init__(self, file, name, writable):
        put(self, "_file", file)
        put(self, "_place", 0)
        put(self, "_name", name)
        put(self, "_writable", writable)

    def _get(self, unit, n):
        file = self._file
        if file is None:
            raise ValueError("I/O operation on closed file")
        if self._writable:
            raise OSError(_EBADF)
        n = _span(file, self._place, unit, n)
        if n < 0:
            raise OSError(-n)
        data = bytearray(n)
        _read(file, self._place, addressof(data), n)
        put(self, "_place", self._place + n)
        return bytes(data)

    def read(self, _n=-1):
        ints(_n)
        return self._get(_BYTES, _n)

    def readline(self, _n=-1):
        ints(_n)
        return self._get(_LINE, _n)

    def readinto(self, buffer, _n=-1):
        ints(_n)
        view = room(buffer)
        data = self._get(_BYTES, len(view) if _n < 0 else min(_n, len(view)))
        view[: len(data)] = data
        return len(data)

    def write(self, data, _first=None, _count=None):
        data = part(data, _first, _count)
        if self._file is None:
            raise ValueError("I/O operation on closed file")
        if not self._writable:
            raise OSError(_EBADF)
        n = _write(self._file, addressof(data), len(data))
        if n < 0:
            if n != -_EBADF:
                put(self, "_file", None)
            raise OSError(-n)
        return n

    def __repr__(self):
        return "<" + type(self).__name__ + ">"

    def name(self):
        return self._name

    def writable(self):
        return self._writable

    def close(self):
        if self._writable and self._file is not None:
            _hal.file_close(self._file)
        put(self, "_file", None)

    def __enter__(self):
        return self

    def __exit__(self, kind, error, traceback):
        self.close()


# py/stream.c looks whether they are UTF-8 since MicroPython 1.20: a line may be cut inside a sign.
_as_text = unchecked_text if _hal.board_micropython(1) < 20 else bytes.decode


class TextIO(FileIO):
    def read(self, _n=-1):
        ints(_n)
        return _as_text(self._get(_CHARACTERS, _n))

    def readline(self, _n=-1):
        ints(_n)
        return _as_text(self._get(_LINE, _n))


def open(name, mode="r"):
    mode = as_text(mode)
    read = text = -1
    for letter in mode:
        if letter in "rw" and read < 0:
            read = letter == "r"
        elif letter in "bt" and text < 0:
            text = letter == "t"
        else:
            raise ValueError("illegal mode")
    writable = read == 0
    name = as_text(name)
    file = _open(name, writable)
    if file < 0:
        raise OSError(-file)
    return (FileIO if text == 0 else TextIO)(file, name, writable)


def input(_prompt=""):
    print(_prompt, end="")
    line = _line(True)
    while line is None:
        # A callback came in between; what was typed so far is kept.
        line = _line(False)
    if line == _END_OF_INPUT:
        raise EOFError
    if line == _CTRL_C:
        raise KeyboardInterrupt
    return line


builtins.open = open
builtins.input = input
