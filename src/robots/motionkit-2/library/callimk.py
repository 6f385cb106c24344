# callimk.py: drive a MotionKit 2 from a Calliope mini 3.
# The names, values and bytes on the wire are those of the library of this name that schools know from WebTigerPython
# (Tiger-Jython/Robotics-Libraries); the code is our own. Runs on the real robot as well.

import gc  # not used here: programs that take everything from callimk may use it, as with the library of that name
from calliope_mini import i2c, sleep

i2c.init()

delay = sleep

_ADDRESS = 0x10
_v = 30  # power of both motors, 15 to 255


def _set(*message):
    """Write bytes to a register and the following ones."""
    i2c.write(_ADDRESS, bytearray(message))


def _get(register, count):
    _set(register)
    return i2c.read(_ADDRESS, count)


# ---- Motors: a register for each, then direction (0 forward, 1 backward) and power ------------------------


def motorL(dir, speed):
    """Left motor: direction 0 forward, 1 backward; power 0 to 255."""
    _set(0x00, dir, speed)


def motorR(dir, speed):
    """Right motor: direction 0 forward, 1 backward; power 0 to 255."""
    _set(0x02, dir, speed)


def w(d1, d2, s1, s2):
    """Directions and powers of the left and the right motor."""
    motorL(d1, s1)
    motorR(d2, s2)


def setSpeed(speed):
    """Power of the following movements, 15 to 255; less counts as 15."""
    global _v
    _v = 15 if speed < 15 else speed


def forward():
    w(0, 0, _v, _v)


def backward():
    w(1, 1, _v, _v)


def left():
    """Turn left on the spot."""
    w(1, 0, _v, _v)


def right():
    """Turn right on the spot."""
    w(0, 1, _v, _v)


def stop():
    w(0, 0, 0, 0)


exit = stop

_AXLE = 0.09  # metres; a constant of the formula, not the distance of the wheels


def _inner(radius):
    """Power of the inner wheel for a circle, radius in metres."""
    if radius < _AXLE:
        return 0
    return int((radius - _AXLE) / (radius + _AXLE) * (1 - _v * _v / 200000) * _v)


def leftArc(r):
    """Circle to the left; radius in metres."""
    w(0, 0, _inner(r), _v)


def rightArc(r):
    """Circle to the right; radius in metres."""
    w(0, 0, _v, _inner(r))


# ---- Lights ---------------------------------------------------------------------------------------


def led(right_left, on_off):
    """One light: 0 is that of register 0x0B, anything else that of 0x0C; 1 on, 0 off."""
    _set(0x0B if right_left == 0 else 0x0C, on_off)


# The library of this name takes 0x0C for the left light; the maker and others take it for the right one.


def setLEDLeft(on):
    """Light of register 0x0C: 1 on, 0 off."""
    led(1, on)


def setLEDRight(on):
    """Light of register 0x0B: 1 on, 0 off."""
    led(0, on)


def setLED(on):
    """Both lights: 1 on, 0 off."""
    led(1, on)
    led(0, on)


def rgbLED(red, green, blue):
    """All colour lights, each part 0 to 255."""
    _set(0x18, red)
    _set(0x19, green)
    _set(0x1A, blue)


# ---- Sensors and servos ------------------------------------------------------------------------------


def getDistance():
    """Distance to the nearest obstacle in cm; 65535 when there is none."""
    _set(0x28)
    sleep(20)
    high, low = i2c.read(_ADDRESS, 2)
    return high << 8 | low


def irLeftValue():
    """Line sensor left: 1 on light ground, 0 on dark ground."""
    return 0 if _get(0x1D, 1)[0] & 1 else 1


def irRightValue():
    """Line sensor right: 1 on light ground, 0 on dark ground."""
    return 0 if _get(0x1D, 1)[0] & 2 else 1


def setServo(S, Angle):
    """Turn the servo at port "S1" or "S2" to an angle from 0 to 180 degrees."""
    if S not in ("S1", "S2"):
        raise ValueError("Unknown servo. Please use 'S1' or 'S2'.")
    _set(0x14 if S == "S1" else 0x15, Angle)
