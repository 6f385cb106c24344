# The module microbit of a micro:bit V2 (firmware v2.1.2).
import _hal as _h
from _bus import MicroBitI2C as _I2C, MicroBitUART as _UART
from _display import MicroBitDisplay as _Display
from _image import MicroBitImage as Image
from _pins import (
    MicroBitAnalogDigitalPin as _AnalogPin,
    MicroBitButton as _Button,
    MicroBitDigitalPin as _DigitalPin,
    MicroBitTouchOnlyPin as _TouchOnlyPin,
    MicroBitTouchPin as _TouchPin,
    pin_number as _pin_number,
)
from _sim import Absent as _Absent, addressof as _addressof, ints as _ints, number as _number, raw as _raw, remember as _remember

_sleep = _h.sleep_ms
_sleep_until = _h.sleep_until
_running_time = _h.running_time

pin0 = _TouchPin(0)
pin1 = _TouchPin(1)
pin2 = _TouchPin(2)
pin3 = _AnalogPin(3)
pin4 = _AnalogPin(4)
pin5 = _DigitalPin(5)
pin6 = _DigitalPin(6)
pin7 = _DigitalPin(7)
pin8 = _DigitalPin(8)
pin9 = _DigitalPin(9)
pin10 = _AnalogPin(10)
pin11 = _DigitalPin(11)
pin12 = _DigitalPin(12)
pin13 = _DigitalPin(13)
pin14 = _DigitalPin(14)
pin15 = _DigitalPin(15)
pin16 = _DigitalPin(16)
pin19 = _DigitalPin(19)
pin20 = _DigitalPin(20)
pin_logo = _TouchOnlyPin(30)
pin_speaker = _DigitalPin(31)
button_a = _Button(0)
button_b = _Button(1)
display = _Display()
i2c = _I2C()
uart = _UART()

accelerometer = _Absent("microbit.accelerometer")
audio = _Absent("microbit.audio")
compass = _Absent("microbit.compass")
microphone = _Absent("microbit.microphone")
speaker = _Absent("microbit.speaker")
spi = _Absent("microbit.spi")
Sound = _Absent("microbit.Sound")
SoundEvent = _Absent("microbit.SoundEvent")


def sleep(ms):
    t = _sleep(ms)
    while t:
        if t < 0:
            _number(ms)
        # A callback came in between: sleep on until the same moment.
        t = _sleep_until(t)


def running_time():
    return _running_time()


def temperature():
    return _h.sensor("temperature")


def set_volume(volume):
    # Loudness has no effect on anything that is simulated.
    _ints(volume)


def panic(n=999):
    _ints(n)
    display.show([Image.SAD] + list("%03d" % n), 800, wait=False, loop=True)
    _h.run_every_stop()
    _h.panic(n)


def reset():
    _h.run_every_stop()
    _h.reset()


def ws2812_write(pin, buf):
    n = _pin_number(pin)
    buf = _raw(buf) if type(buf) is not bytearray else buf
    _h.ws2812_write(n, _addressof(buf), len(buf))


def run_every(callback=None, *, days=0, h=0, min=0, s=0, ms=0):
    _ints(days, h, min, s, ms)
    period = (((days * 24 + h) * 60 + min) * 60 + s) * 1000 + ms

    def start(callback):
        _h.run_every(_remember(callback), period)
        return callback

    return start if callback is None else start(callback)


def scale(value, from_, to):
    low, high = to
    start, end = from_
    result = (value - start) / (end - start) * (high - low) + low
    return result if isinstance(low, float) or isinstance(high, float) else round(result)
