# mbled.py: a ring of 24 colour LEDs (ws2812) on pin 2. It can lie on any robot, or beside the board.
# Names and effects are those of the school library (Tiger-Jython Robotics-Libraries, mbled.py); the code is our own.

from microbit import pin2
from neopixel import NeoPixel

_COUNT = 24
_ring = NeoPixel(pin2, _COUNT)


def fill(red, green, blue):
    """One colour for all LEDs, each part 0 to 255."""
    _ring.fill((red, green, blue))
    _ring.show()


def set_led(pos, red, green, blue):
    """The colour of one LED, 0 to 23; the others stay as they are."""
    _ring[pos] = (red, green, blue)
    _ring.show()


def clear():
    """All LEDs off."""
    _ring.clear()


def shift_by(amount):
    """Moves the picture on the ring: LED 0 takes the colour of LED number amount, and so on all around."""
    before = [_ring[pos] for pos in range(_COUNT)]
    for pos in range(_COUNT):
        _ring[pos] = before[(pos + amount) % _COUNT]
    _ring.show()


def _between(start, end, percent):
    return min(255, max(0, round(start + (end - start) * percent / 100)))


def lerp_RGB(r1, g1, b1, r2, g2, b2, percent):
    """The colour that lies so many percent of the way from the first to the second, as (red, green, blue)."""
    if not 0 <= percent <= 100:
        raise RuntimeError("percent must be from 0 to 100, not {}".format(percent))
    return _between(r1, r2, percent), _between(g1, g2, percent), _between(b1, b2, percent)
