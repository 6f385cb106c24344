# The compass. Names: micropython-microbit-v2 microbit_compass.c.
import _hal
from _sim import refuse_attribute


class MicroBitCompass:
    __setattr__ = refuse_attribute

    def __repr__(self):
        return "<MicroBitCompass>"

    def heading(self):
        return _hal.compass_heading()

    def is_calibrated(self):
        return _hal.compass_is_calibrated()

    def calibrate(self):
        _hal.compass_calibrate()

    def clear_calibration(self):
        _hal.compass_forget()

    def get_x(self):
        return _hal.compass_field(0)

    def get_y(self):
        return _hal.compass_field(1)

    def get_z(self):
        return _hal.compass_field(2)

    def get_field_strength(self):
        return _hal.compass_strength()
