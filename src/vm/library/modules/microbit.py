# The module of the board: microbit, or calliopemini on a Calliope mini. Differences between boards are data (_hal.board_…).
import sys as _sys
import _hal as _h
import _pins as _kinds
import audio
from _audio import MicroBitSound as Sound, MicroBitSpeaker as _Speaker
from _bus import MicroBitI2C as _I2C, MicroBitSPI as _SPI, MicroBitUART as _UART
from _compass import MicroBitCompass as _Compass
from _display import MicroBitDisplay as _Display
from _image import MicroBitImage as Image
from _microphone import MicroBitMicrophone as _Microphone, MicroBitSoundEvent as SoundEvent
from _motion import MicroBitAccelerometer as _Accelerometer
from _pins import MicroBitButton as _Button, board_pins as _board_pins, pin_number as _pin_number
from _sim import (
    addressof as _addressof,
    ints as _ints,
    number as _number,
    put as _put,
    raw as _raw,
    refuse_attribute as _refuse_attribute,
    remember as _remember,
)

_sleep = _h.sleep_ms
_spend = _h.spend_scale
_temperature = _h.temperature
_sleep_until = _h.sleep_until
_running_time = _h.running_time

# By setattr, which makes texts names: one key that is none makes every look-up here compare texts.
_this = _sys.modules["microbit"]
for _name, _value in _board_pins().items():
    setattr(_this, _name, _value)
button_a = _Button(0)
button_b = _Button(1)
display = _Display()
i2c = _I2C()
spi = _SPI()
uart = _UART()

accelerometer = _Accelerometer()
compass = _Compass()
microphone = _Microphone()
speaker = _Speaker()


def sleep(ms):
    try:
        t = _sleep(ms) if -1 < ms < 0x40000000 else _check_time(ms)
    except TypeError:
        t = _check_time(ms)
    while t:
        # A callback came in between: sleep on until the same moment.
        t = _sleep_until(t)


def _check_time(ms):
    # Less than nothing, more than the device can count, or no number at all.
    if isinstance(ms, int):
        _ints(ms)
    elif not isinstance(ms, float):
        _number(ms)
    # C makes the nearest int of a decimal, and 0 of what is no number.
    return _sleep(min(ms, 0x7FFFFFFF) if ms > 0 else 0)


def running_time():
    return _running_time()


def temperature():
    return _temperature()


def set_volume(volume):
    _ints(volume)
    _h.set_volume(volume)


def panic(_n=999):
    _ints(_n)
    display.show([Image.SAD] + list("%03d" % _n), 800, wait=False, loop=True)
    _h.run_every_stop()
    _h.panic(_n)


def reset():
    _h.run_every_stop()
    _h.reset()


def ws2812_write(pin, buf):
    n = _pin_number(pin)
    buf = _raw(buf) if type(buf) is not bytearray else buf
    _h.ws2812_write(n, _addressof(buf), len(buf))


class run_every:
    __setattr__ = _refuse_attribute

    def __init__(self, period):
        _put(self, "_period", period)

    def __call__(self, *callbacks):
        if len(callbacks) != 1:
            raise TypeError("function takes 1 positional arguments but %d were given" % len(callbacks))
        callback = callbacks[0]
        # Days of milliseconds have more than 32 bits: days and the rest go to the simulation.
        _h.run_every(_remember(callback), self._period // 86400000, self._period % 86400000)
        return self

    def __repr__(self):
        return "<run_every>"


_RunEvery = run_every


def run_every(callback=None, *, days=0, h=0, min=0, s=0, ms=0):
    _ints(days, h, min, s, ms)
    # In C a number of 32 bits: 50 days are 7 hours.
    timer = _RunEvery((((days * 24 + h) * 60 + min) * 60 + s) * 1000 + ms & 0xFFFFFFFF)
    return timer if callback is None else timer(callback)


# Built-in names are looked for here first, among more than a hundred: these are found at once.
_type = type
_len = len
_round = round
_tuple = tuple
_float = float
_INFINITE = float("inf")  # what a division by zero makes of floats in C
_BEYOND = 2147483648.0


def _pair(value):
    if not isinstance(value, (tuple, list)):
        raise TypeError("object '%s' isn't a tuple or list" % type(value).__name__)
    if len(value) != 2:
        raise ValueError("requested length 2 but object has length %d" % len(value))
    return value


# The last parameter lets the others be named, as on the device (src/vm/firmware/native-calls.mjs).
def scale(value, from_, to, *, _=None):
    start, end = from_ if _type(from_) is _tuple and _len(from_) == 2 else _pair(from_)
    low, high = to if _type(to) is _tuple and _len(to) == 2 else _pair(to)
    try:
        span = end - start
        result = ((value - start) / span if span else (value - start) * _INFINITE) * (high - low) + low
    except TypeError:
        for number in (value, start, end, low, high):
            _number(number)
        raise
    _spend()
    if _type(low) is _float or _type(high) is _float:
        return result
    return _round(result) if -_BEYOND < result < _BEYOND else _clipped(result)


def _clipped(result):
    # As C makes ints of floats on this processor: the nearest one that it has; 0 of what is no number.
    return 0x7FFFFFFF if result > 0 else -0x80000000 if result < 0 else 0


def _name_module():
    """The board's names for this module; it calls itself by the first."""
    global __name__
    this = _sys.modules["microbit"]
    __name__ = _h.board_module(0)
    _sys.modules[__name__] = this
    if __name__ == "calliopemini":
        # Type hints number these pins, too.
        names = ("pin16", "pin_A1_RX"), ("pin17", "pin_A1_TX"), ("pin19", "pin_A0_SCL"), ("pin20", "pin_A0_SDA")
        for hint, name in names:
            setattr(_this, hint, getattr(_this, name))
        import _calliope

        _sys.modules["calliope_mini"] = _calliope


# What `from microbit import *` brings: what the device has. The names below are for type hints alone, which editors give
# to pupils; the device has these types, but no names for them.
__all__ = tuple([name for name in globals() if name[0] != "_"])
Button = _Button
for _name in dir(_kinds):
    if _name.startswith("MicroBit"):
        setattr(_this, _name, getattr(_kinds, _name))
del MicroBitButton
_name_module()
