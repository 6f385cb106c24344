# callibot.py: drive a Calli:bot from a Calliope mini 3.
# The names, values and bytes on the wire are those of the library of this name that schools know from WebTigerPython
# (Tiger-Jython/Robotics-Libraries, version 1.3); the code is our own. Runs on the real robot as well.

from calliope_mini import i2c, sleep

delay = sleep

_MOTORS = 0x20
_LIGHTS = 0x21

_AXLE = 0.06  # metres; the arcs were tried out with this number
_v = 90  # power of both motors: speed 50


def _hang():
    print("Please switch on Robot!")
    while True:
        sleep(100)


def _send(address, message):
    try:
        i2c.write(address, message)
    except OSError:
        _hang()


# ---- Motors: a write of register, direction (0 forward, 1 backward), power for each ----------------


def w(d1, d2, s1, s2):
    """Directions and powers of the left and the right motor."""
    _send(_MOTORS, bytearray((0, d1, s1)))
    _send(_MOTORS, bytearray((2, d2, s2)))


def setSpeed(speed):
    """Speed of the following movements, about 10 to 200; the power is 40 more, as motors need 40 to move."""
    global _v
    _v = speed + 40


def forward():
    w(0, 0, _v, _v)


def backward():
    w(1, 1, _v, _v)


def stop():
    w(0, 0, 0, 0)


exit = stop


def left():
    """Turn left on the spot, with a tenth more power."""
    power = int(_v * 1.1)
    ahead = int(_v > 0)
    w(ahead, 1 - ahead, power, power)


def right():
    """Turn right on the spot, with a tenth more power."""
    power = int(_v * 1.1)
    ahead = int(_v > 0)
    w(1 - ahead, ahead, power, power)


def _arc(radius):
    """Power of the inner and the outer wheel for a circle, radius in metres."""
    outer = abs(_v)
    if radius < _AXLE:
        return 0, outer
    share = (radius - _AXLE) / (radius + _AXLE) * (1 - outer * outer / 200000)
    return int(share * outer), outer


def leftArc(radius):
    """Circle to the left; radius in metres. Backward when the speed is below -40."""
    inner, outer = _arc(radius)
    if _v > 0:
        w(0, 0, inner, outer)
    else:
        w(1, 1, outer, inner)


def rightArc(radius):
    """Circle to the right; radius in metres. Backward when the speed is below -40."""
    inner, outer = _arc(radius)
    if _v > 0:
        w(0, 0, outer, inner)
    else:
        w(1, 1, inner, outer)


class Motor:
    """One motor; the other one keeps its speed."""

    def __init__(self, register):
        self._register = register

    def rotate(self, speed):
        """Turn with this speed, -200 to 200; negative is backward, 0 stops."""
        power = abs(speed) + 50 if speed else 0
        _send(_MOTORS, bytearray((self._register, int(speed < 0), power)))


motL = Motor(0)
motR = Motor(2)

# ---- Red lights: one byte for both, so each of these functions first turns both off --------------------


def _light(mask, on):
    _send(_LIGHTS, b"\x00\x00")
    i2c.write(_LIGHTS, bytearray((0, mask if on == 1 else 0)))


def setLEDLeft(on):
    """Left light on (1) or off (0); turns the right one off."""
    _light(1, on)


def setLEDRight(on):
    """Right light on (1) or off (0); turns the left one off."""
    _light(2, on)


def setLED(on):
    """Both lights on (1) or off (0)."""
    _light(3, on)


# ---- Sensors: bit 0 line right, 1 line left, 2 bumper right, 3 bumper left, 7 always set -----------------


def _read(count):
    try:
        return i2c.read(_LIGHTS, count)
    except OSError:
        _hang()


def _is_one_of(values):
    return 1 if _read(1)[0] in values else 0


# These compare the whole byte, as on the robot: a line sensor gives 0 while the bumper is pressed, and the bumper gives
# 0 while only one of the line sensors sees light ground.


def irLeftValue():
    """Line sensor left: 1 on light ground, 0 on dark ground."""
    return _is_one_of((0x82, 0x83))


def irRightValue():
    """Line sensor right: 1 on light ground, 0 on dark ground."""
    return _is_one_of((0x81, 0x83))


def tsValue():
    """1 while both halves of the bumper are pressed."""
    return _is_one_of((0x8C, 0x8F))


def tsLeftValue():
    """1 while only the left half of the bumper is pressed."""
    return _is_one_of((0x88, 0x8B))


def tsRightValue():
    """1 while only the right half of the bumper is pressed."""
    return _is_one_of((0x84, 0x87))


def getDistance():
    """Distance to the nearest obstacle in cm, with one decimal."""
    answer = _read(3)
    return (256 * answer[1] + answer[2]) / 10


# ---- The other spelling, that of TigerJython's simulated Calli:bot ----------------------------------------


class Sensor:
    """One bit of the sensors, or several that must all be set."""

    def __init__(self, bits):
        self._bits = bits

    def read_digital(self):
        return 1 if _read(1)[0] & self._bits == self._bits else 0

    getValue = read_digital


irRight = Sensor(1)
irLeft = Sensor(2)
tsRight = Sensor(4)
tsLeft = Sensor(8)
ts = Sensor(12)


def setAlarm(on):
    """Two tones again and again in the background: 1 on, 0 off."""
    import cbalarm

    cbalarm.setAlarm(on)
