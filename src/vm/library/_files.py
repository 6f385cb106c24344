# open() and input() of the device. Behaviour and errors: MicroPython microbitfs.c; input: lib/mp-readline.
import builtins
import _hal
from _sim import addressof, ints, raw

_read = _hal.file_read
_write = _hal.file_write
_span = _hal.file_span
_line = _hal.serial_input
_BYTES = 0
_CHARACTERS = 1
_LINE = 2
_EBADF = 9
_END_OF_INPUT = 4


class FileIO:
    def __init__(self, handle, name, writable):
        self._handle = handle
        self._name = name
        self._writable = writable

    def _get(self, unit, n):
        handle = self._handle
        if handle is None:
            raise ValueError("I/O operation on closed file")
        n = _span(handle, unit, n)
        if n < 0:
            raise OSError(-n)
        data = bytearray(n)
        _read(handle, addressof(data), n)
        return bytes(data)

    def read(self, n=-1):
        ints(n)
        return self._get(_BYTES, n)

    def readline(self, n=-1):
        ints(n)
        return self._get(_LINE, n)

    def readinto(self, buffer, n=-1):
        view = memoryview(buffer)
        data = self._get(_BYTES, len(view) if n < 0 else min(n, len(view)))
        view[: len(data)] = data
        return len(data)

    def write(self, data):
        handle = self._handle
        if handle is None:
            raise ValueError("I/O operation on closed file")
        data = raw(data)
        n = _write(handle, addressof(data), len(data))
        if n < 0:
            if n != -_EBADF:
                self._handle = None
            raise OSError(-n)
        return n

    def name(self):
        return self._name

    def writable(self):
        return self._writable

    def close(self):
        if self._handle is not None:
            _hal.file_close(self._handle)
            self._handle = None

    def __enter__(self):
        return self

    def __exit__(self, kind, error, traceback):
        self.close()

    def __iter__(self):
        return self

    def __next__(self):
        line = self.readline()
        if not line:
            raise StopIteration
        return line


class TextIO(FileIO):
    def read(self, n=-1):
        ints(n)
        return self._get(_CHARACTERS, n).decode()

    def readline(self, n=-1):
        ints(n)
        return self._get(_LINE, n).decode()

    def write(self, data):
        if not isinstance(data, str):
            return FileIO.write(self, data)
        FileIO.write(self, data)
        return len(data)


def open(name, mode="r"):
    read = text = -1
    for letter in mode:
        if letter in "rw" and read < 0:
            read = letter == "r"
        elif letter in "bt" and text < 0:
            text = letter == "t"
        else:
            raise ValueError("illegal mode")
    writable = read == 0
    if not isinstance(name, str):
        raise TypeError("can't convert '%s' object to str implicitly" % type(name).__name__)
    handle = _hal.file_open(name, writable)
    if handle < 0:
        raise OSError(-handle)
    return (FileIO if text == 0 else TextIO)(handle, name, writable)


def input(prompt=""):
    print(prompt, end="")
    line = _line()
    while line is None:
        # A callback came in between; what was typed so far is kept.
        line = _line()
    if line == _END_OF_INPUT:
        raise EOFError
    return line


builtins.open = open
builtins.input = input
