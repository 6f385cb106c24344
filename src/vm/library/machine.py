# The device's machine module.
import _hal as _h
from _pins import pin_number as _pin_number
from _sim import Absent as _Absent, addressof as _addressof
from microbit import reset

_pulse = _h.pulse
_pulse_on = _h.pulse_on

mem8 = _Absent("machine.mem8")
mem16 = _Absent("machine.mem16")
mem32 = _Absent("machine.mem32")


def time_pulse_us(pin, level, timeout_us=1000000):
    t = _pulse(_pin_number(pin), level, timeout_us)
    while t < -2:
        # A callback came in between; the measurement goes on meanwhile.
        t = _pulse_on(t)
    return t


def unique_id():
    device = bytearray(8)
    _h.unique_id(_addressof(device))
    return bytes(device)


def freq():
    return 64000000


def disable_irq():
    return _h.set_irq(False)


def enable_irq(state):
    _h.set_irq(state)
