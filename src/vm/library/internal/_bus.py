# I2C, SPI and serial. Behaviour and errors: micropython-microbit-v2 microbit_i2c.c, microbit_spi.c, microbit_uart.c.
import _hal
from _pins import pin_number
from _sim import addressof, ints, part, raw, refuse_attribute, room

_write = _hal.i2c_write
_read = _hal.i2c_read
_ENODEV = 19
_INVALID_PARAMETER = -1001  # codal-core ErrorNo.h: DEVICE_INVALID_PARAMETER
_USB = -1
_SDA = _hal.board_role("sda")
_SCL = _hal.board_role("scl")
_keeps_pins = not _hal.board_has("i2c-pins")


class MicroBitI2C:
    __setattr__ = refuse_attribute

    def __repr__(self):
        return "<MicroBitI2C>"

    def init(self, freq=100000, sda=None, scl=None):
        ints(freq)
        sda = _SDA if sda is None else pin_number(sda)
        scl = _SCL if scl is None else pin_number(scl)
        if _keeps_pins:
            sda = _SDA
            scl = _SCL
        _hal.i2c_init(freq, scl, sda)

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
            n |= 0
        if n < 0:
            ints(n)
            raise MemoryError("memory allocation failed, allocating %d bytes" % (n & 0xFFFFFFFF))
        buf = bytearray(n)
        r = _read(addr, addressof(buf), n)
        if r:
            ints(addr)
            raise OSError(_ENODEV)
        return bytes(buf)


class MicroBitSPI:
    __setattr__ = refuse_attribute

    def __repr__(self):
        return "<MicroBitSPI>"

    def init(self, baudrate=1000000, bits=8, mode=0, *, sclk=None, mosi=None, miso=None):
        ints(baudrate, bits, mode)
        pins = []
        for pin, usual in ((sclk, 13), (mosi, 15), (miso, 14)):
            pins.append(usual if pin is None else pin_number(pin))
        for n in pins:
            holder = _hal.spi_hold(n)
            if holder is not None:
                raise ValueError("Pin %d in %s mode" % (n, holder))
        if bits != 8:
            raise OSError(_INVALID_PARAMETER)
        _hal.spi_init(pins[0], pins[1], pins[2], baudrate, mode)

    def write(self, buffer):
        _check_spi()
        buffer = raw(buffer)
        _hal.spi_transfer(addressof(buffer), 0, len(buffer))

    def read(self, nbytes, _out=0):
        _check_spi()
        ints(nbytes, _out)
        if nbytes < 0:
            raise ValueError("invalid number of bytes")
        nbytes |= 0
        buffer = bytearray(nbytes)
        _out &= 0xFF
        if _out:
            for i in range(nbytes):
                buffer[i] = _out
        _hal.spi_transfer(addressof(buffer), addressof(buffer), nbytes)
        return bytes(buffer)

    def write_readinto(self, out, in_):
        _check_spi()
        sent = raw(out)
        received = room(in_)
        if len(sent) != len(received):
            raise ValueError("write and read buffers must be the same length")
        buffer = bytearray(len(sent))
        _hal.spi_transfer(addressof(sent), addressof(buffer), len(sent))
        received[:] = buffer


def _check_spi():
    if not _hal.spi_is_on():
        raise ValueError("SPI not initialised")


class MicroBitUART:
    __setattr__ = refuse_attribute
    ODD = 1
    EVEN = 0

    def __repr__(self):
        return "<MicroBitUART>"

    def init(self, baudrate=9600, bits=8, parity=None, stop=1, *, pins=None, tx=None, rx=None):
        ints(baudrate, bits, stop)
        if parity is not None:
            ints(parity)
        tx = _USB if tx is None else pin_number(tx)
        rx = _USB if rx is None else pin_number(rx)
        if pins is not None:
            if not isinstance(pins, (tuple, list)):
                raise TypeError("object '%s' isn't a tuple or list" % type(pins).__name__)
            if len(pins) != 2:
                raise ValueError("requested length 2 but object has length %d" % len(pins))
            tx = pin_number(pins[0])
            rx = pin_number(pins[1])
        _hal.uart_init(baudrate, tx, rx)

    def any(self):
        return _hal.uart_waiting() > 0

    def _take(self, n):
        data = bytearray(n)
        _hal.uart_read(addressof(data), n)
        return bytes(data)

    def read(self, _nbytes=-1):
        ints(_nbytes)
        data = b""
        while _nbytes < 0 or len(data) < _nbytes:
            n = _hal.uart_waiting()
            if n:
                data += self._take(n if _nbytes < 0 else min(n, _nbytes - len(data)))
            elif not data or not self._more():
                break
        return data if data or not _nbytes else None

    def _more(self):
        more = None
        while more is None:
            # A callback in between ends the syscall early.
            more = _hal.uart_more()
        return more

    def readline(self, _max_size=-1):
        ints(_max_size)
        n = _hal.uart_line()
        if _max_size >= 0:
            n = min(n, _max_size)
        return self._take(n) if n else None

    def readinto(self, buf, _nbytes=-1):
        ints(_nbytes)
        view = room(buf)
        data = self.read(len(view) if _nbytes < 0 else min(_nbytes, len(view)))
        if data is None:
            return None
        view[: len(data)] = data
        return len(data)

    def write(self, buf, _first=None, _count=None):
        buf = part(buf, _first, _count)
        _hal.uart_write(addressof(buf), len(buf))
        return len(buf)
