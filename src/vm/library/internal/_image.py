# Image. Behaviour and errors: micropython-microbit-v2 microbit_image.c.
import _hal
from _sim import addressof, ints

_glyph = _hal.glyph
_unpack = _hal.image_unpack
_size = _hal.image_size
_parse = _hal.image_parse
_limit = _hal.image_limit
_sum = _hal.image_sum
_scale = _hal.image_scale
_invert = _hal.image_invert
_fill = _hal.image_fill
_pixel = _hal.image_pixel
_blit = _hal.image_blit
_text = _hal.image_text

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
    # A built-in image is one whole number, 25 bits, until it is looked at; any other has its pixels in a bytearray.
    _w = 5
    _h = 5

    def __init__(self, *args):
        n = len(args)
        if n == 0:
            self._b = bytearray(25)
        elif n == 1:
            text = args[0]
            if not isinstance(text, str):
                raise TypeError("Image(s) takes a string")
            if len(text) == 1:
                self._b = bytearray(25)
                _glyph(text, addressof(self._b))
            else:
                self._parse(text)
        elif n <= 3:
            self._sized(*args)
        else:
            raise TypeError("function expected at most 3 arguments, got %d" % n)

    def _sized(self, w, h, data=None):
        ints(w, h)
        if data is None:
            self._b = bytearray(w * h)
        else:
            view = memoryview(data)
            if w < 0 or h < 0 or w * h != len(view):
                raise ValueError("image data is incorrect size")
            self._b = bytearray(view)
            _limit(addressof(self._b), w * h)
        self._w = w
        self._h = h

    def _parse(self, text):
        size = _size(text)
        self._w = size >> 12
        self._h = size & 4095
        self._b = bytearray(self._w * self._h)
        if not _parse(text, addressof(self._b), self._w):
            raise ValueError("unexpected character in Image definition")

    def _pixels(self):
        b = self._b
        if type(b) is int:
            pixels = bytearray(25)
            _unpack(b, addressof(pixels))
            return pixels
        return b

    def _own(self):
        b = self._b
        if type(b) is int:
            raise TypeError("image cannot be modified (try copying first)")
        return b

    def width(self):
        return self._w

    def height(self):
        return self._h

    def _place(self, x, y):
        _pixel()
        try:
            x | y
        except TypeError:
            ints(x, y)
        if x < 0 or y < 0:
            raise ValueError("index cannot be negative")
        if x >= self._w or y >= self._h:
            raise ValueError("index too large")
        return y * self._w + x

    def get_pixel(self, x, y):
        i = self._place(x, y)
        b = self._b
        if type(b) is int:
            return (b >> 24 - i & 1) * 9
        return b[i]

    def set_pixel(self, x, y, value):
        b = self._own()
        try:
            x | y | value
        except TypeError:
            ints(x, y, value)
        if x >= 0 <= y and not 0 <= value <= 9:
            raise ValueError("brightness out of bounds")
        b[self._place(x, y)] = value

    def fill(self, value):
        b = self._own()
        ints(value)
        if not 0 <= value <= 9:
            raise ValueError("brightness out of bounds")
        _fill(addressof(b), len(b), value)

    def copy(self):
        return self.crop(0, 0, self._w, self._h)

    def invert(self):
        image = _image(self._w, self._h)
        pixels = self._pixels()
        _invert(addressof(pixels), len(pixels), addressof(image._b))
        return image

    def crop(self, x, y, w, h):
        ints(x, y, w, h)
        image = _image(max(w, 0), max(h, 0))
        image._copy_from(self, x, y, image._w, image._h, 0, 0)
        return image

    def blit(self, src, x, y, w, h, xdest=0, _ydest=None):
        self._own()
        if not isinstance(src, MicroBitImage):
            raise TypeError("expecting an image")
        if _ydest is None:
            if xdest:
                raise TypeError("must specify both offsets")
            _ydest = 0
        ints(x, y, w, h, xdest, _ydest)
        if w < 0 or h < 0:
            raise ValueError("size cannot be negative")
        self._copy_from(src, x, y, w, h, xdest, _ydest)

    def _copy_from(self, src, x, y, w, h, xdest, ydest):
        pixels = src._pixels()
        _blit(
            *(addressof(pixels), src._w, src._h, x, y),
            *(addressof(self._b), self._w, self._h, xdest, ydest, w, h),
        )

    def _shift(self, x, y):
        # As high as it is wide, as on the device (image_shift).
        return self.crop(x, y, self._w, self._w)

    def shift_left(self, n):
        return self._shift(n, 0)

    def shift_right(self, n):
        return self._shift(-n, 0)

    def shift_up(self, n):
        return self._shift(0, n)

    def shift_down(self, n):
        return self._shift(0, -n)

    def _plus(self, other, sign):
        if self._w != other._w or self._h != other._h:
            raise ValueError("images must be the same size")
        a = self._pixels()
        b = other._pixels()
        image = _image(self._w, self._h)
        _sum(addressof(a), addressof(b), len(a), sign, addressof(image._b))
        return image

    def __add__(self, other):
        if not isinstance(other, MicroBitImage):
            return NotImplemented
        return self._plus(other, 1)

    def __sub__(self, other):
        if not isinstance(other, MicroBitImage):
            return NotImplemented
        return self._plus(other, -1)

    def __mul__(self, factor):
        factor = _number(factor)
        if factor < 0:
            raise ValueError("brightness multiplier must not be negative")
        image = _image(self._w, self._h)
        pixels = self._pixels()
        _scale(addressof(pixels), self._w, self._h, factor, addressof(image._b))
        return image

    def __truediv__(self, divisor):
        return self * (1.0 / _number(divisor))

    def _rows(self, between):
        pixels = self._pixels()
        return _text(addressof(pixels), self._w, self._h, between)

    def __repr__(self):
        return "Image('" + self._rows("") + "')"

    def __str__(self):
        return "Image(\n    '" + self._rows("'\n    '") + "'\n)"


def _image(w, h):
    image = object.__new__(MicroBitImage)
    image._w = w
    image._h = h
    image._b = bytearray(w * h)
    return image


def _number(value):
    if isinstance(value, (int, float)):
        return value
    raise TypeError("can't convert %s to float" % type(value).__name__)


def _add_constants(words):
    for i in range(0, len(words), 2):
        image = object.__new__(MicroBitImage)
        image._b = int(words[i + 1], 32)
        setattr(MicroBitImage, words[i], image)


def _add_list(name, members):
    setattr(MicroBitImage, name, tuple(getattr(MicroBitImage, member) for member in members))


_add_constants(_CONSTANTS.split())
_add_list("ALL_CLOCKS", ["CLOCK%d" % (hour or 12) for hour in range(12)])
_add_list("ALL_ARROWS", ["ARROW_" + way for way in "N NE E SE S SW W NW".split()])
