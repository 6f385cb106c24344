# colour.py: a colour sensor TCS34725 (TCS34721 at 0x39) in the words of the classroom. Our own code; it talks to the
# sensor as its data sheet says and runs on real boards as well: put this file on the board.
#
# The sensor shines on what lies before it and measures red, green and blue. 10 mm above the floor is best.

from microbit import i2c, sleep

# Readings over white paper: clear, red, green, blue. calibrate() measures them anew.
_white = [7000, 2018, 2623, 2359]
_awake = []


def _wake(address):
    """Switch the sensor on: gain 4, measurements of 24 ms; wait for the first one."""
    i2c.write(address, b"\x81\xf6")
    i2c.write(address, b"\x8f\x01")
    i2c.write(address, b"\x80\x01")
    sleep(3)
    i2c.write(address, b"\x80\x03")
    sleep(30)
    _awake.append(address)


def raw(address=0x29):
    """Clear, red, green and blue as the sensor gives them."""
    if address not in _awake:
        _wake(address)
    i2c.write(address, b"\xb4")
    data = i2c.read(address, 8)
    return tuple(data[i] + 256 * data[i + 1] for i in (0, 2, 4, 6))


def calibrate(address=0x29):
    """What the sensor sees now is white paper."""
    _white[:] = [max(value, 1) for value in raw(address)]


def _shares(address):
    """The readings compared with white paper."""
    return [value / white for value, white in zip(raw(address), _white)]


def rgb(address=0x29):
    """Red, green and blue, 0 to 255 each; white paper is 255, 255, 255."""
    return tuple(min(255, round(255 * share)) for share in _shares(address)[1:])


def brightness(address=0x29):
    """Percent of white paper."""
    return min(100, round(100 * _shares(address)[0]))


def _hue(red, green, blue):
    most = max(red, green, blue)
    span = most - min(red, green, blue)
    if span == 0:
        return 0
    if most == red:
        sixths = (green - blue) / span
    elif most == green:
        sixths = 2 + (blue - red) / span
    else:
        sixths = 4 + (red - green) / span
    return round(60 * sixths) % 360


def hue(address=0x29):
    """The colour as an angle, 0 to 359: red 0, yellow 60, green 120, blue 240."""
    return _hue(*_shares(address)[1:])


def name(address=0x29):
    """The colour as a word."""
    level, red, green, blue = _shares(address)
    most = max(red, green, blue)
    span = most - min(red, green, blue)
    if most == 0 or span / most < 0.2:
        return "white" if level > 0.75 else "gray" if level > 0.24 else "black"
    angle = _hue(red, green, blue)
    if angle < 45 and span / most < 0.55 and level < 0.32:
        return "brown"
    for limit, word in ((10, "red"), (35, "orange"), (85, "yellow"), (170, "green"), (250, "blue"), (330, "purple")):
        if angle < limit:
            return word
    return "red"
