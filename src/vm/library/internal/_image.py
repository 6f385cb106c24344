# Image. Behaviour and errors: micropython-microbit-v2 microbit_image.c; pictures: microbit_constimage.c.
# @license micropython-microbit-v2 (pictures, melodies, pitches): MIT. Copyright (c) 2015-2020 Damien P. George.
import _hal
from _sim import addressof, ints, put, refuse_attribute

_glyph = _hal.glyph
_head = _hal.image_head
_width = _hal.image_width
_height = _hal.image_height
_unpack = _hal.image_unpack
_size = _hal.image_size
_parse = _hal.image_parse
_limit = _hal.image_limit
_sum = _hal.image_sum
_scale = _hal.image_scale
_invert = _hal.image_invert
_copy = _hal.image_copy
_crop = _hal.image_crop
_fill = _hal.image_fill
_pixel = _hal.image_pixel
_set = _hal.image_set
_blit = _hal.image_blit
_text = _hal.image_text

_new = object.__new__
_NUMBERS = (int, float)
_INFINITE = float("inf")
# In a buffer, before the pixels: width, height, whether it cannot be modified (src/vm/run/hal/image.ts).
_HEAD = 5

# The built-in images (micropython-microbit-v2 microbit_constimage.c): a base-32 digit per row, its highest bit on the left.
_CONSTANTS = (
    "HEART avve4 HEART_SMALL 0ae40 HAPPY 0a0he SMILE 000he SAD 0a0eh CONFUSED 0a0al ANGRY ha0vl "
    "ASLEEP 0r0e0 SURPRISED a04a4 SILLY h0v57 FABULOUS vr0ae MEH a0248 YES 012k8 NO ha4ah CLOCK12 44400 "
    "CLOCK1 22400 CLOCK2 03400 CLOCK3 00700 CLOCK4 00430 CLOCK5 00422 CLOCK6 00444 CLOCK7 00488 "
    "CLOCK8 004o0 CLOCK9 00s00 CLOCK10 0o400 CLOCK11 88400 ARROW_N 4el44 ARROW_NE 7358g ARROW_E 42v24 "
    "ARROW_SE g8537 ARROW_S 44le4 ARROW_SW 12kos ARROW_W 48v84 ARROW_NW sok21 TRIANGLE 04av0 "
    "TRIANGLE_LEFT gokiv CHESSBOARD alala DIAMOND 4aha4 DIAMOND_SMALL 04a40 SQUARE vhhhv "
    "SQUARE_SMALL 0eae0 RABBIT kkuqu COW hhve4 MUSIC_CROTCHET 444ss MUSIC_QUAVER 465ss "
    "MUSIC_QUAVERS f99rr PITCHFORK llv44 XMAS 4e4ev PACMAN fqsuf TARGET 4ere4 TSHIRT rveee "
    "ROLLERSKATE 33vva DUCK csfe0 HOUSE 4evea TORTOISE 0eva0 BUTTERFLY rv4vr STICKFIGURE 4v4ah "
    "GHOST vlvvl SWORD 444e4 GIRAFFE o88ea SKULL elvee UMBRELLA ev4kc SNAKE orae0 SCISSORS pq4qp"
)


class MicroBitImage:
    # One attribute, the buffer: each further one would make three objects more.
    __setattr__ = refuse_attribute

    def __init__(self, *args):
        n = len(args)
        if n == 0:
            self._sized(5, 5)
        elif n == 1:
            text = args[0]
            if not isinstance(text, str):
                raise TypeError("Image(s) takes a string")
            if len(text) == 1 and text < "\x80":
                self._sized(5, 5)
                _glyph(text, addressof(self._b) + _HEAD)
            else:
                size = _size(text)
                b = bytearray((size >> 12) * (size & 4095) + _HEAD)
                put(self, "_b", b)
                if not _parse(addressof(b)):
                    raise ValueError("unexpected character in Image definition")
        elif n == 2:
            w, h = args
            try:
                fits = not (w | h) & -65536
            except TypeError:
                fits = False
            if fits:
                b = bytearray(w * h + _HEAD)
                put(self, "_b", b)
                _head(addressof(b), w, h)
            else:
                self._sized(w, h)
        elif n == 3:
            self._sized(args[0], args[1], args[2])
        else:
            raise TypeError("function expected at most 3 arguments, got %d" % n)

    def _sized(self, w, h, data=None):
        try:
            if (w | h) & -65536:
                ints(w, h)
        except TypeError:
            ints(w, h)
        if data is not None:
            data = memoryview(data)
            if w < 0 or h < 0 or w * h != len(data):
                raise ValueError("image data is incorrect size")
        elif w < 0 or h < 0:
            bytearray(-1)
        b = bytearray(w * h + _HEAD)
        put(self, "_b", b)
        _head(addressof(b), w, h)
        if data is not None:
            b[_HEAD:] = data
            _limit(addressof(b))

    def _own(self):
        if self._b[4]:
            raise TypeError("image cannot be modified (try copying first)")

    def width(self):
        return _width(addressof(self._b))

    def height(self):
        return _height(addressof(self._b))

    # Numbers that are negative or too large for any image do not go to the simulation.
    def get_pixel(self, x, y):
        try:
            value = -1 if (x | y) & -65536 else _pixel(addressof(self._b), x, y)
        except TypeError:
            value = ints(x, y)
        if value < 0:
            ints(x, y)
            raise ValueError("index cannot be negative" if x < 0 or y < 0 else "index too large")
        return value

    def set_pixel(self, x, y, value):
        try:
            if not (x | y | value) & -65536 and not _set(addressof(self._b), x, y, value):
                return
        except TypeError:
            pass
        self._own()
        ints(x, y, value)
        if x >= 0 <= y and not 0 <= value <= 9:
            raise ValueError("brightness out of bounds")
        raise ValueError("index cannot be negative" if x < 0 or y < 0 else "index too large")

    def fill(self, value):
        try:
            if not value & -16 and not _fill(addressof(self._b), value | 0):
                return
        except TypeError:
            pass
        self._own()
        ints(value)
        raise ValueError("brightness out of bounds")

    def copy(self):
        b = self._b
        image = _new(MicroBitImage)
        to = bytearray(len(b))
        put(image, "_b", to)
        _copy(addressof(b), addressof(to))
        return image

    def invert(self):
        b = self._b
        image = _new(MicroBitImage)
        to = bytearray(len(b))
        put(image, "_b", to)
        _invert(addressof(b), addressof(to))
        return image

    def crop(self, x, y, w, h):
        try:
            if (x | y | w | h) & -65536:
                ints(x, y, w, h)
                w = max(w, 0)
                h = max(h, 0)
        except TypeError:
            ints(x, y, w, h)
        image = _new(MicroBitImage)
        to = bytearray(w * h + _HEAD)
        put(image, "_b", to)
        _crop(addressof(self._b), x, y, w, h, addressof(to))
        return image

    def blit(self, src, x, y, w, h, xdest=0, _ydest=None):
        self._own()
        if not isinstance(src, MicroBitImage):
            raise TypeError("expecting an image")
        if _ydest is None:
            if xdest:
                raise TypeError("must specify both offsets")
            _ydest = 0
        try:
            if (x | y | w | h | xdest | _ydest) & -65536:
                ints(x, y, w, h, xdest, _ydest)
        except TypeError:
            ints(x, y, w, h, xdest, _ydest)
        if w < 0 or h < 0:
            raise ValueError("size cannot be negative")
        _blit(addressof(src._b), x, y, addressof(self._b), xdest, _ydest, w, h)

    def shift_left(self, n):
        try:
            if n & -65536:
                ints(n)
        except TypeError:
            ints(n)
        return _shifted(self._b, n, 0)

    def shift_right(self, n):
        try:
            if n & -65536:
                ints(n)
        except TypeError:
            ints(n)
        return _shifted(self._b, -n, 0)

    def shift_up(self, n):
        try:
            if n & -65536:
                ints(n)
        except TypeError:
            ints(n)
        return _shifted(self._b, 0, n)

    def shift_down(self, n):
        try:
            if n & -65536:
                ints(n)
        except TypeError:
            ints(n)
        return _shifted(self._b, 0, -n)

    def __add__(self, other):
        if not isinstance(other, MicroBitImage):
            return NotImplemented
        return _plus(self._b, other._b, 1)

    def __sub__(self, other):
        if not isinstance(other, MicroBitImage):
            return NotImplemented
        return _plus(self._b, other._b, -1)

    def __mul__(self, factor):
        return _scaled(self._b, _number(factor))

    def __truediv__(self, divisor):
        divisor = _number(divisor)
        # What C makes of it: every pixel becomes as bright as can be.
        return _scaled(self._b, 1.0 / divisor if divisor else _INFINITE)

    def __repr__(self):
        return _text(addressof(self._b), False)

    def __str__(self):
        return _text(addressof(self._b), True)


def _shifted(b, x, y):
    # As high as it is wide, as on the device (image_shift).
    w = b[0] | b[1] << 8
    image = _new(MicroBitImage)
    to = bytearray(w * w + _HEAD)
    put(image, "_b", to)
    _crop(addressof(b), x, y, w, w, addressof(to))
    return image


def _plus(a, b, sign):
    image = _new(MicroBitImage)
    to = bytearray(len(a))
    put(image, "_b", to)
    if not _sum(addressof(a), addressof(b), sign, addressof(to)):
        raise ValueError("images must be the same size")
    return image


def _scaled(b, factor):
    if factor < 0:
        raise ValueError("brightness multiplier must not be negative")
    image = _new(MicroBitImage)
    to = bytearray(len(b))
    put(image, "_b", to)
    _scale(addressof(b), factor, addressof(to))
    return image


def _number(value):
    if isinstance(value, _NUMBERS):
        return value
    raise TypeError("can't convert %s to float" % type(value).__name__)


def _add_constants(words):
    for i in range(0, len(words), 2):
        image = _new(MicroBitImage)
        b = bytearray(25 + _HEAD)
        put(image, "_b", b)
        _unpack(int(words[i + 1], 32), addressof(b))
        setattr(MicroBitImage, words[i], image)


def _add_list(name, members):
    setattr(MicroBitImage, name, tuple(getattr(MicroBitImage, member) for member in members))


_add_constants(_CONSTANTS.split())
_add_list("ALL_CLOCKS", ["CLOCK%d" % (hour or 12) for hour in range(12)])
_add_list("ALL_ARROWS", ["ARROW_" + way for way in "N NE E SE S SW W NW".split()])
