# The device's machine module: micropython-microbit-v2 modmachine.c, MicroPython extmod/machine_mem.c.
import _hal as _h
from _pins import pin_number as _pin_number
from _sim import addressof as _addressof, ints as _ints, put as _put, refuse_attribute as _refuse_attribute
from microbit import reset

_pulse = _h.pulse


class _Memory:
    """Bytes, half words or words of the chip. Only what names the chip is there to read (hal-device.ts)."""

    __setattr__ = _refuse_attribute

    def __init__(self, bits):
        _put(self, "_bits", bits)

    def __repr__(self):
        return "<%u-bit memory>" % self._bits

    def _missing(self, what, address):
        raise NotImplementedError("%s machine.mem%d[0x%08x] is not simulated" % (what, self._bits, address))

    def _checked(self, address):
        _ints(address)
        size = self._bits // 8
        address &= 0xFFFFFFFF
        if address % size:
            raise ValueError("address %08x is not aligned to %u bytes" % (address, size))
        return address

    def __getitem__(self, address):
        word = _h.chip_word(self._checked(address) & ~3)
        if word is None:
            self._missing("reading", address)
        return (word >> 8 * (address & 3)) & (1 << self._bits) - 1

    def __setitem__(self, address, value):
        _ints(value)
        self._missing("writing", self._checked(address))


mem8 = _Memory(8)
mem16 = _Memory(16)
mem32 = _Memory(32)


def time_pulse_us(pin, level, _timeout_us=1000000):
    n = _pin_number(pin)
    _ints(_timeout_us)
    # Callbacks that came meanwhile run at the program's next jump: here is none after the measurement.
    return _pulse(n, True if level else False, _timeout_us)


def unique_id():
    device = bytearray(8)
    _h.unique_id(_addressof(device))
    return bytes(device)


def freq():
    return 64000000


def disable_irq():
    # The state is the processor's mask: 1 when interrupts were off already.
    return 0 if _h.set_irq(False) else 1


def enable_irq(state):
    _ints(state)
    _h.set_irq(not state)
