# I2C and serial. Behaviour and errors: micropython-microbit-v2 microbit_i2c.c, microbit_uart.c.
import _hal
from _pins import pin_number
from _sim import absent, addressof, ints, raw

_write = _hal.i2c_write
_read = _hal.i2c_read
_ENODEV = 19


class MicroBitI2C:
    def __repr__(self):
        return "<MicroBitI2C>"

    def init(self, freq=100000, sda=None, scl=None):
        ints(freq)
        if sda is not None and pin_number(sda) != 20 or scl is not None and pin_number(scl) != 19:
            absent("microbit.i2c on other pins than pin20 (sda) and pin19 (scl)")
        _hal.i2c_init(freq)

    def scan(self):
        found = []
        address = _hal.i2c_next(0x07)
        while address >= 0:
            found.append(address)
            address = _hal.i2c_next(address)
        return found

    def write(self, addr, buf, repeat=False):
        if type(buf) is not bytearray and type(buf) is not bytes:
            buf = raw(buf)
        r = _write(addr, addressof(buf), len(buf))
        if r:
            ints(addr)
            raise OSError(_ENODEV)

    def read(self, addr, n, repeat=False):
        if type(n) is not int:
            ints(n)
        if n < 0:
            raise MemoryError("memory allocation failed, allocating %d bytes" % (n & 0xFFFFFFFF))
        buf = bytearray(n)
        r = _read(addr, addressof(buf), n)
        if r:
            ints(addr)
            raise OSError(_ENODEV)
        return bytes(buf)


class MicroBitUART:
    ODD = 1
    EVEN = 0

    def __repr__(self):
        return "<MicroBitUART>"

    def init(self, baudrate=9600, bits=8, parity=None, stop=1, *, pins=None, tx=None, rx=None):
        ints(baudrate, bits, stop)
        if pins is not None or tx is not None or rx is not None:
            absent("microbit.uart on other pins than USB")
        _hal.serial_init(baudrate)

    def any(self):
        return _hal.serial_waiting() > 0

    def _take(self, n):
        if not n:
            return None
        data = bytearray(n)
        _hal.serial_read(addressof(data), n)
        return bytes(data)

    def read(self, nbytes=-1):
        waiting = _hal.serial_waiting()
        return self._take(waiting if nbytes < 0 else min(nbytes, waiting))

    def readline(self):
        return self._take(_hal.serial_line())

    def readinto(self, buf, nbytes=-1):
        view = memoryview(buf)
        n = min(_hal.serial_waiting(), len(view) if nbytes < 0 else min(nbytes, len(view)))
        if not n:
            return None
        view[:n] = self._take(n)
        return n

    def write(self, buf):
        buf = raw(buf)
        _hal.serial_write(addressof(buf), len(buf))
        return len(buf)
