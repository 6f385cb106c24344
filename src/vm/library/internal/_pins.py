# Pins, touch pads and buttons. Names and errors: micropython-microbit-v2 microbit_pin.c, microbit_pinmode.c, microbit_button.c.
import _hal
from _sim import ints, put, refuse_attribute

_read = _hal.pin_read
_write = _hal.pin_write
_read_analog = _hal.pin_read_analog
_write_analog = _hal.pin_write_analog
_mode = _hal.pin_mode
_mode_place = _hal.pin_mode_place
# A text from the simulation is looked for among all names each time: these are fetched once.
_MODES = _hal.pin_modes().split()
_touched = _hal.touch_is
_pressed = _hal.button_is
_was_pressed = _hal.button_was
_presses = _hal.button_presses

_counts_touches = _hal.board_has("touch-counts")

_HELD = -1
_OUT_OF_RANGE = -2


def _held(n):
    raise ValueError("Pin %d in %s mode" % (n, _mode(n)))


class MicroBitDigitalPin:
    PULL_UP = 0
    PULL_DOWN = 1
    NO_PULL = 2
    __setattr__ = refuse_attribute

    def __init__(self, n):
        put(self, "_n", n)

    def __repr__(self):
        return "<" + type(self).__name__ + ">"

    def read_digital(self):
        level = _read(self._n)
        if level < 0:
            _held(self._n)
        return level

    def write_digital(self, value):
        try:
            r = _OUT_OF_RANGE if value & -2 else _write(self._n, value & 1)
        except TypeError:
            r = ints(value)
        if r:
            if r == _HELD:
                _held(self._n)
            ints(value)
            raise ValueError("value must be 0 or 1")

    def write_analog(self, value):
        try:
            # Whole numbers of more than 32 bits would reach the simulation as others.
            r = _write_analog(self._n, value) if -2 < value < 1025 else _OUT_OF_RANGE
        except TypeError:
            r = ints(value)
        if r:
            if r == _HELD:
                _held(self._n)
            if isinstance(value, int):
                ints(value)
            raise ValueError("value must be between 0 and 1023")

    def set_pull(self, value):
        ints(value)
        if _hal.pin_set_pull(self._n, value):
            _held(self._n)

    def get_pull(self):
        pull = _hal.pin_pull(self._n)
        if pull < 0:
            _held(self._n)
        return pull

    def get_mode(self):
        return _MODES[_mode_place(self._n)]

    def set_analog_period(self, period):
        ints(period)
        # As many bits as the device has; more would not reach the simulation.
        _hal.pin_set_period(self._n, (period * 1000 + 0x80000000 & 0xFFFFFFFF) - 0x80000000)

    def set_analog_period_microseconds(self, period):
        ints(period)
        _hal.pin_set_period(self._n, period)

    def get_analog_period_microseconds(self):
        return _hal.pin_period(self._n)


class MicroBitAnalogDigitalPin(MicroBitDigitalPin):
    def read_analog(self):
        value = _read_analog(self._n)
        if value < 0:
            _held(self._n)
        return value


class MicroBitTouchOnlyPin:
    RESISTIVE = 0
    CAPACITIVE = 1
    __setattr__ = refuse_attribute

    def __init__(self, n):
        put(self, "_n", n)

    __repr__ = MicroBitDigitalPin.__repr__

    def is_touched(self):
        touched = _touched(self._n)
        if touched is None:
            _held(self._n)
        return touched

    if _counts_touches:

        def was_touched(self):
            touched = _hal.touch_was(self._n)
            if touched is None:
                _held(self._n)
            return touched

        def get_touches(self):
            touches = _hal.touch_count(self._n)
            if touches < 0:
                _held(self._n)
            return touches

        def touch_calibrate(self):
            # Finds the level of an untouched pad. A simulated pad does not drift, so it needs no calibration.
            _touched(self._n)

    def set_touch_mode(self, value):
        ints(value)
        if _hal.touch_set_kind(self._n, value):
            _held(self._n)


class MicroBitTouchPin(MicroBitAnalogDigitalPin):
    RESISTIVE = 0
    CAPACITIVE = 1
    # The calls of polling loops, found without climbing through the bases.
    read_digital = MicroBitDigitalPin.read_digital
    write_digital = MicroBitDigitalPin.write_digital
    is_touched = MicroBitTouchOnlyPin.is_touched
    set_touch_mode = MicroBitTouchOnlyPin.set_touch_mode
    if _counts_touches:
        was_touched = MicroBitTouchOnlyPin.was_touched
        get_touches = MicroBitTouchOnlyPin.get_touches
        touch_calibrate = MicroBitTouchOnlyPin.touch_calibrate


class MicroBitButton:
    __setattr__ = refuse_attribute

    def __init__(self, n):
        put(self, "_n", n)

    __repr__ = MicroBitDigitalPin.__repr__

    def is_pressed(self):
        return _pressed(self._n)

    def was_pressed(self):
        return _was_pressed(self._n)

    def get_presses(self):
        return _presses(self._n)


def pin_number(pin):
    """The number by which the simulation knows a pin."""
    if isinstance(pin, MicroBitDigitalPin):
        return pin._n
    raise TypeError("expecting a pin")


_CLASSES = {
    "touch": MicroBitTouchPin,
    "analog": MicroBitAnalogDigitalPin,
    "digital": MicroBitDigitalPin,
    "touch-only": MicroBitTouchOnlyPin,
}


def board_pins():
    """The pins of this board by their names."""
    pins = {}
    while True:
        pin = _hal.board_pin(len(pins))
        if pin is None:
            return pins
        name, number, kind = pin.split()
        pins[name] = _CLASSES[kind](int(number))
