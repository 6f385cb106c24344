# The 5 x 5 display. Behaviour and errors: micropython-microbit-v2 microbit_display.c, drv_display.c.
import _hal
from _image import MicroBitImage
from _sim import addressof, ints

_show_bits = _hal.display_show_bits
_show_image = _hal.display_show_image
_show_text = _hal.display_show_text
_scroll = _hal.display_scroll
_add_bits = _hal.display_add_bits
_add_image = _hal.display_add_image
_add_text = _hal.display_add_text
_run = _hal.display_run
_busy = _hal.display_busy
_set_pixel = _hal.display_set_pixel
_get_pixel = _hal.display_get_pixel


def _wait():
    # A callback in between ends the syscall early: ask again until the animation is over.
    while _busy():
        pass


def _send(image, bits, pixels):
    b = image._b
    if type(b) is int:
        bits(b)
    else:
        pixels(addressof(b), image._w, image._h)


def _add(frame):
    """Adds one picture to the sequence. False at a text that is no single character, which ends it; None at anything else."""
    if isinstance(frame, MicroBitImage):
        _send(frame, _add_bits, _add_image)
    elif not isinstance(frame, str):
        return None
    elif len(frame) == 1:
        _add_text(frame)
    else:
        return False
    return True


class MicroBitDisplay:
    def __repr__(self):
        return "<MicroBitDisplay>"

    def show(self, image, delay=400, *, clear=False, wait=True, loop=False):
        if isinstance(image, MicroBitImage):
            if not clear and not loop:
                _send(image, _show_bits, _show_image)
                return
            image = (image,)
        ints(delay)
        if isinstance(image, (int, float)):
            image = str(image)
        if isinstance(image, str):
            if _show_text(image, delay, bool(loop), bool(clear)) and wait:
                _wait()
            return
        self._sequence(image, delay, clear, wait, loop)

    def _sequence(self, frames, delay, clear, wait, loop):
        _hal.display_begin()
        if wait and not loop and not isinstance(frames, (tuple, list)):
            self._one_by_one(frames, delay, clear)
            return
        added = True
        for frame in frames:
            added = _add(frame)
            if not added:
                break
        is_moving = _run(delay, bool(loop), bool(clear))
        if is_moving and wait:
            _wait()
        if added is None:
            raise TypeError("not an image")

    def _one_by_one(self, frames, delay, clear):
        # Pictures that a generator makes one by one, perhaps without end: each is asked for when it is due.
        for frame in frames:
            added = _add(frame)
            if added is None:
                raise TypeError("not an image")
            if not added:
                break
            _run(delay, False, False)
            _wait()
        if clear:
            self.clear()

    def scroll(self, text, delay=150, *, wait=True, monospace=False, loop=False):
        if isinstance(text, (int, float)):
            text = str(text)
        elif not isinstance(text, str):
            raise TypeError("can't convert '%s' object to str implicitly" % type(text).__name__)
        ints(delay)
        _scroll(text, delay, bool(loop), bool(monospace))
        if wait:
            _wait()

    def clear(self):
        # Takes effect at the next tick of the display, which the device waits for.
        _hal.display_clear()
        _wait()

    def set_pixel(self, x, y, value):
        try:
            x | y | value
        except TypeError:
            ints(x, y, value)
        r = _set_pixel(x, y, value)
        if r:
            raise ValueError("index out of bounds" if r == -1 else "brightness out of bounds")

    def get_pixel(self, x, y):
        try:
            x | y
        except TypeError:
            ints(x, y)
        value = _get_pixel(x, y)
        if value < 0:
            raise ValueError("index out of bounds")
        return value

    if _hal.board_has("rotate"):

        def rotate(self, angle):
            ints(angle)
            _hal.display_rotate((angle + 45) // 90 & 3)

    def on(self):
        problem = _hal.display_on()
        if problem:
            raise ValueError(problem)

    def off(self):
        _hal.display_off()

    def is_on(self):
        return _hal.display_is_on()

    def read_light_level(self):
        return _hal.sensor("lightLevel")
