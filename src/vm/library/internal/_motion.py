# The accelerometer. Names and errors: micropython-microbit-v2 microbit_accelerometer.c.
import _hal
from _sim import ints, refuse_attribute, text

_axis = _hal.acceleration
_too = _hal.acceleration_too
_gesture = _hal.gesture
_was = _hal.gesture_was
_NAMES = _hal.gesture_names().split("\n")
_PLACES = {name: place for place, name in enumerate(_NAMES)}


def _unknown(name):
    text(name)
    raise ValueError("invalid gesture")


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
        return (_axis(0), _too(1), _too(2))

    def get_strength(self):
        return _hal.acceleration_strength()

    def current_gesture(self):
        return _NAMES[_gesture()]

    def is_gesture(self, name):
        gesture = _gesture()
        try:
            return gesture == _PLACES[name]
        except (KeyError, TypeError):
            _unknown(name)

    def was_gesture(self, name):
        try:
            place = _PLACES[name]
        except (KeyError, TypeError):
            _unknown(name)
        return _was(place)

    def get_gestures(self):
        made = _hal.gestures()
        return tuple(made.split("\n")) if made else ()

    def set_range(self, value):
        ints(value)
        _hal.acceleration_range(value)
