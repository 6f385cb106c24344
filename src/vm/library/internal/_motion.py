# The accelerometer. Names and errors: micropython-microbit-v2 microbit_accelerometer.c.
import _hal
from _sim import ints, refuse_attribute, text

_axis = _hal.acceleration
_gesture = _hal.gesture
_GESTURES = (
    ("", "up", "down", "left", "right", "face up", "face down")
    + ("freefall", "2g", "3g", "6g", "8g", "shake")
)


def _known(name):
    text(name)
    if name not in _GESTURES:
        raise ValueError("invalid gesture")
    return name


class MicroBitAccelerometer:
    __setattr__ = refuse_attribute

    def __repr__(self):
        return "<MicroBitAccelerometer>"

    def get_x(self):
        return _axis(0)

    def get_y(self):
        return _axis(1)

    def get_z(self):
        return _axis(2)

    def get_values(self):
        return (_axis(0), _hal.acceleration_too(1), _hal.acceleration_too(2))

    def get_strength(self):
        return _hal.acceleration_strength()

    def current_gesture(self):
        return _gesture()

    def is_gesture(self, name):
        return _gesture() == _known(name)

    def was_gesture(self, name):
        return _hal.gesture_was(_known(name))

    def get_gestures(self):
        made = _hal.gestures()
        return tuple(made.split("\n")) if made else ()

    def set_range(self, value):
        ints(value)
        _hal.acceleration_range(value)
