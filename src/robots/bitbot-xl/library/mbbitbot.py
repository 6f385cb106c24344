# mbbitbot.py: drive a bit:bot XL from a micro:bit V2.
# The names, values and signals on the pins are those of the library that WebTigerPython brings along
# (Tiger-Jython/Robotics-Libraries), its oddities included; the code is our own. Runs on the real robot as well.

from microbit import *
from neopixel import *
from utime import ticks_us, sleep_us

# ---- Motors: a pin for forward and one for backward each, powers 0 to 1023 -------------------------

_FULL = 1023

_v = 200
_offset = 0
_differential = 0


def w(leftforward, leftbackward, rightforward, rightbackward):
    """The powers of the four motor pins, 0 to 1023. Does nothing when some are negative and none is positive."""
    ahead = astern = 0
    if leftforward > 0 or rightforward > 0:
        ahead = _differential
    elif leftbackward > 0 or rightbackward > 0:
        astern = _differential
    elif leftforward or leftbackward or rightforward or rightbackward:
        return
    pin16.write_analog(leftforward + ahead)
    pin8.write_analog(leftbackward + astern)
    pin14.write_analog(rightforward - ahead)
    pin12.write_analog(rightbackward - astern)


def forward():
    w(_v, 0, _v, 0)


def backward():
    w(0, _v, 0, _v)


def right():
    """The left wheel turns backward, the right one forward: on the spot to the LEFT, as in the original."""
    w(0, _v, _v, 0)


def left():
    """The left wheel turns forward, the right one backward: on the spot to the RIGHT, as in the original."""
    w(_v, 0, 0, _v)


def stop():
    w(0, 0, 0, 0)


def _inner(radius):
    return _v * (radius / (radius + 1))


def leftArc(radius):
    """To the left, the left wheel slower: the larger the radius, the less. It is not the circle's real radius."""
    w(_inner(radius), 0, _v, 0)


def rightArc(radius):
    """To the right, the right wheel slower: the larger the radius, the less. It is not the circle's real radius."""
    w(_v, 0, _inner(radius), 0)


def setSpeed(percent):
    """Speed of the following movements in percent, 0 to 100."""
    global _v
    _v = min(max((percent + _offset) / 100 * _FULL, 0), _FULL)


def calibrate(offset, differential=0):
    """Power added (percent) and left against right (of 1023), -50 to 50 each. Then fails, as the original does."""
    global _offset, _differential
    _offset = max(min(int(offset), 50), -50)
    _differential = max(min(int(differential), 50), -50)
    raise NameError("name 'arcScaling' isn't defined")


# ---- Lights: six on the left arm, six on the right one ---------------------------------------------

_COUNT = 12
_np = NeoPixel(pin13, _COUNT)


def set_led(pos, red, green, blue):
    """The colour of one light, 0 to 11; each part 0 to 255."""
    _np[pos] = (red, green, blue)
    _np.show()


def fill(red, green, blue):
    """One colour for all lights, each part 0 to 255."""
    for pos in range(_COUNT):
        _np[pos] = (red, green, blue)
    _np.show()


# ---- Sensors -----------------------------------------------------------------------------------------


def getDistance():
    """Distance to the nearest obstacle in cm. Waits for ever when there is none."""
    pin15.write_digital(1)
    sleep_us(10)
    pin15.write_digital(0)
    pin15.set_pull(pin15.NO_PULL)
    while not pin15.read_digital():
        pass
    begin = ticks_us()
    while pin15.read_digital():
        pass
    return int(0.01715 * (ticks_us() - begin))


def getLine(bit):
    """A line sensor, 0 left, 1 right: 1 on dark ground, 0 on light ground, or when the robot is off."""
    try:
        return (i2c.read(0x1C, 1)[0] >> bit) & 1
    except OSError:
        return 0


def getLight(index):
    """A light sensor, 0 right, 1 left: 0 dark to 1023 bright."""
    if index == 0:
        return pin1.read_analog()
    if index == 1:
        return pin2.read_analog()
