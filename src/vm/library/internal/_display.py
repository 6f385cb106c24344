# The 5 x 5 display. Behaviour and errors: micropython-microbit-v2 microbit_display.c, drv_display.c.
import _hal
from _image import MicroBitImage
from _sim import addressof, ints, raise_in_program, refuse_attribute, remember, text as as_text

_show_image = _hal.display_show_image
_show_text = _hal.display_show_text
_scroll = _hal.display_scroll
_add_image = _hal.display_add_image
_add_text = _hal.display_add_text
_run = _hal.display_run
_turn = _hal.display_turn
_moves_on = _hal.display_moves_on
# Callbacks that come meanwhile run at the program's next jump: so no jump may follow it here.
_wait = _hal.display_wait
_set_pixel = _hal.display_set_pixel
_get_pixel = _hal.display_get_pixel
_is_on = _hal.display_is_on
_light = _hal.light_level

_int = int
_str = str
_NUMBERS = (int, float, bool)
# A text that is made anew is looked for among all names.
_DIGITS = tuple("0123456789")


def _add(frame):
    """Adds one picture to the sequence. False at a text that is not of one byte, which ends it; None at anything else."""
    if isinstance(frame, MicroBitImage):
        _add_image(addressof(frame._b))
    elif not isinstance(frame, str):
        return None
    else:
        return _add_text(frame)
    return True


_shown = None

# Pictures that a generator makes one by one, perhaps without end: each is fetched when it is due.
_frames = None
_delay = 0
_clear = False


def _one_by_one(frames, delay, clear, wait):
    global _frames, _delay, _clear
    _frames = frames
    _delay = delay
    _clear = bool(clear)
    if not wait:
        _next_frame(_due)
        return
    turn = -1
    # Something else that is shown meanwhile takes their place.
    while _frames is frames and turn in (-1, _turn()):
        _next_frame(-1)
        turn = _turn()
        _wait()
    if _frames is frames:
        _frames = None


def _next_frame(due):
    """Shows the next one; the end of the pictures, and an error, end the sequence. The callback is for the one after."""
    global _frames
    try:
        added = _add(next(_frames))
        if added is None:
            raise TypeError("not an image")
        if added:
            _run(_delay, False, False, due)
            return
    except StopIteration:
        if _clear:
            _run(_delay, False, True)
    except BaseException:
        _frames = None
        raise
    _frames = None


def _next_frame_is_due():
    if _frames is not None and _moves_on():
        try:
            _next_frame(_due)
        except BaseException as error:
            raise_in_program(error)


_due = remember(_next_frame_is_due)


class MicroBitDisplay:
    __setattr__ = refuse_attribute

    def __repr__(self):
        return "<MicroBitDisplay>"

    def show(self, image, delay=400, *, clear=False, wait=True, loop=False):
        kind = type(image)
        if kind is _int and 0 <= image <= 9:
            image = _DIGITS[image]
            kind = _str
        elif kind is _str:
            pass
        elif isinstance(image, MicroBitImage):
            if not clear and not loop:
                _show_image(addressof(image._b))
                return
            image = (image,)
        elif kind in _NUMBERS:
            image = str(image)
            kind = _str
        try:
            if delay & -0x40000000:
                ints(delay)
        except TypeError:
            ints(delay)
        if kind is _str:
            if _show_text(image, delay, True if loop else False, True if clear else False) and wait:
                _wait()
            return
        self._sequence(image, delay, clear, wait, loop)

    def _sequence(self, frames, delay, clear, wait, loop):
        global _shown
        _hal.display_begin()
        if not isinstance(frames, (tuple, list)):
            if loop:
                # The device repeats by number: what has no length and no places cannot be repeated.
                frames = [frames[place] for place in range(len(frames))]
            else:
                _one_by_one(iter(frames), delay, clear, wait)
                return
        # Read when they are due: kept until then.
        frames = _shown = tuple(frames)
        added = True
        for frame in frames:
            added = _add(frame)
            if not added:
                break
        waits = _run(delay, bool(loop), bool(clear)) and wait
        if added is None:
            if waits:
                _wait()
            raise TypeError("not an image")
        if waits:
            _wait()

    def scroll(self, text, delay=150, *, wait=True, monospace=False, loop=False):
        text = str(text) if isinstance(text, (int, float, bool)) else as_text(text)
        ints(delay)
        _scroll(text, delay, bool(loop), bool(monospace))
        if wait:
            _wait()

    if _hal.board_has("clear-ends"):

        def clear(self):
            # Takes effect at the next tick of the display, which the device waits for.
            _hal.display_clear()
            _wait()

    else:

        def clear(self):
            _hal.display_blank()

    def set_pixel(self, x, y, value):
        try:
            if (x | y | value) & -16:
                ints(x, y, value)
        except TypeError:
            ints(x, y, value)
        r = _set_pixel(x, y, value)
        if r:
            raise ValueError("index out of bounds" if r == -1 else "brightness out of bounds")

    def get_pixel(self, x, y):
        try:
            if (x | y) & -16:
                ints(x, y)
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
        return _is_on()

    def read_light_level(self):
        return _light()
