# controller.py: DFRobot's gamepad for the micro:bit, its stick and keys. The names and values are those of the library that
# schools know from TigerJython (Tiger-Jython/Robotics-Libraries); the code is our own. Runs on real boards as well.

from microbit import button_a, button_b, pin1, pin2, pin8, pin12, pin13, pin14, pin15, pin16, run_every


class _Key:
    """A key that pulls its pin down; it is asked like the board's own buttons."""

    def __init__(self, pin):
        pin.set_pull(pin.PULL_UP)
        self._pin = pin
        self._is_down = False
        self._presses = 0
        self._was_pressed = False

    def _look(self):
        was_down = self._is_down
        self._is_down = self.is_pressed()
        if self._is_down and not was_down:
            self._presses += 1
            self._was_pressed = True

    def is_pressed(self):
        return self._pin.read_digital() == 0

    def was_pressed(self):
        was, self._was_pressed = self._was_pressed, False
        return was

    def get_presses(self):
        presses, self._presses = self._presses, 0
        return presses


def _within(low, value, high):
    return min(high, max(low, value))


class _Axis:
    """One direction of the stick: -1 to 1."""

    def __init__(self, pin):
        self._pin = pin
        self.set(0.01, 0, -1, 1)

    def set(self, dead_zone, center, least, most):
        self._dead_zone = dead_zone
        self._center = center
        self._down = center - least
        self._up = most - center

    def get(self):
        off = self._pin.read_analog() / 512 - 1 - self._center
        if abs(off) > self._dead_zone / 2:
            off /= self._down if off < 0 else self._up
        return 0.0 if abs(off) <= self._dead_zone else _within(-1.0, off, 1.0)


class _Stick:
    """The stick: two directions, and a key when it is pressed in."""

    def __init__(self):
        self._x = _Axis(pin1)
        self._y = _Axis(pin2)
        self.button_z = _Key(pin8)
        self.is_pressed = self.button_z.is_pressed
        self.was_pressed = self.button_z.was_pressed
        self.get_presses = self.button_z.get_presses

    def get_x(self):
        return self._x.get()

    def get_y(self):
        return self._y.get()

    def get_z(self):
        return int(self.is_pressed())

    def calibrate(self, dead_zone, center_x=0.0, center_y=0.0, x_min=-1.0, x_max=1.0, y_min=-1.0, y_max=1.0):
        """What the stick gives at rest and at its ends, for one that is worn out."""
        dead_zone = _within(0.01, dead_zone, 0.2)
        for axis, center, most_off, low, high in (
            (self._x, center_x, 0.4, x_min, x_max),
            (self._y, center_y, 0.5, y_min, y_max),
        ):
            center = _within(-most_off, center, most_off)
            axis.set(dead_zone, center, _within(-1, low, -0.5), _within(0.5, high, 1))


joystick = _Stick()
button_z = joystick.button_z
button_c = button_green = _Key(pin13)
button_d = button_yellow = _Key(pin14)
button_e = button_red = _Key(pin15)
button_f = button_blue = _Key(pin16)
trigger_left = button_a
trigger_right = button_b


def vibrate(state):
    """The motor and its light: 1 on, 0 off."""
    pin12.write_digital(state)


def _look():
    for key in (button_z, button_c, button_d, button_e, button_f):
        key._look()


run_every(_look, ms=33)
