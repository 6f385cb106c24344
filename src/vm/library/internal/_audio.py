# Shared by audio, music and speech, and the built-in sounds, effects and frames.
# Behaviour and errors: micropython-microbit-v2 modaudio.c, microbit_sound.c, microbit_soundeffect.c, microbit_pinaudio.c;
# recording (the newest firmware): microbit_audiorecording.c, microbit_audiotrack.c.
import _hal as _h
from _pins import pin_number
from _sim import addressof, ints, number, put, raw, refuse_attribute

# The pin that carries sound unless the program names another: pin0.
DEFAULT_PIN = 0

has_recording = _h.board_has("recording")


def output(pin):
    """The number of the pin that will carry sound, -1 for none."""
    if pin is None:
        return -1
    return pin if pin is DEFAULT_PIN else pin_number(pin)


def check(problem):
    if problem:
        raise ValueError(problem)


class MicroBitSpeaker:
    __setattr__ = refuse_attribute

    def __repr__(self):
        return "<MicroBitSpeaker>"

    def on(self):
        _h.speaker(True)

    def off(self):
        _h.speaker(False)


class MicroBitSound:
    __setattr__ = refuse_attribute

    def __init__(self, name):
        put(self, "_name", name)

    def __repr__(self):
        return "Sound('" + self._name + "')"


for _name in "giggle happy hello mysterious sad slide soaring spring twinkle yawn".split():
    setattr(MicroBitSound, _name.upper(), MicroBitSound(_name))

_PART_LENGTH = 72
_MAXIMA = {1: "9", 2: "99", 3: "255", 4: "9999"}


def _field(first, digits):
    def get(self):
        return int(self._digits[first : first + digits])

    def set(self, value):
        self._put(first, digits, value)

    return property(get, set)


def _volume(first):
    # Volumes go from 0 to 255; what is stored goes to 1023.
    def get(self):
        return (int(self._digits[first : first + 4]) * 255 + 511) // 1023

    def set(self, value):
        ints(value)
        if not 0 <= value <= 255:
            raise ValueError("maximum value is 255")
        self._put(first, 4, (value * 1023 + 127) // 255)

    return property(get, set)


class MicroBitSoundEffect:
    __setattr__ = refuse_attribute

    WAVEFORM_SINE = 0
    WAVEFORM_SAWTOOTH = 1
    WAVEFORM_TRIANGLE = 2
    WAVEFORM_SQUARE = 3
    WAVEFORM_NOISE = 4
    SHAPE_LINEAR = 1
    SHAPE_CURVE = 2
    SHAPE_LOG = 18
    FX_NONE = 0
    FX_VIBRATO = 1
    FX_TREMOLO = 2
    FX_WARBLE = 3

    freq_start = _field(5, 4)
    freq_end = _field(18, 4)
    duration = _field(9, 4)
    vol_start = _volume(1)
    vol_end = _volume(26)
    waveform = _field(0, 1)
    fx = _field(34, 2)
    shape = _field(13, 2)

    def __init__(
        self,
        freq_start=500,
        freq_end=2500,
        duration=500,
        vol_start=255,
        vol_end=0,
        waveform=WAVEFORM_SQUARE,
        fx=FX_NONE,
        shape=SHAPE_LOG,
    ):
        # The steps of the frequency, and parameter and steps of vibrato and others, are fixed.
        put(self, "_digits", "0" * 30 + "0128" + "00" + "0001" + "0024" + "0" * 28)
        self.freq_start = freq_start
        self.freq_end = freq_end
        self.duration = duration
        self.vol_start = vol_start
        self.vol_end = vol_end
        self.waveform = waveform
        self.fx = fx
        self.shape = shape

    def _put(self, first, digits, value):
        ints(value)
        text = "%0*d" % (digits, value)
        if value < 0 or len(text) > digits:
            raise ValueError("maximum value is " + _MAXIMA[digits])
        put(self, "_digits", self._digits[:first] + text + self._digits[first + digits :])

    @staticmethod
    def _from_string(text):
        effect = MicroBitSoundEffect()
        put(effect, "_digits", (text + "0" * _PART_LENGTH)[:_PART_LENGTH])
        return effect

    def copy(self):
        return MicroBitSoundEffect._from_string(self._digits)

    def _values(self):
        return (
            self.freq_start,
            self.freq_end,
            self.duration,
            self.vol_start,
            self.vol_end,
            self.waveform,
            self.fx,
            self.shape,
        )

    def __repr__(self):
        return "SoundEffect(%d, %d, %d, %d, %d, %d, %d, %d)" % self._values()

    def __str__(self):
        values = list(self._values())
        for place, prefix in ((5, "WAVEFORM_"), (6, "FX_"), (7, "SHAPE_")):
            for name in dir(MicroBitSoundEffect):
                if name.startswith(prefix) and getattr(MicroBitSoundEffect, name) == values[place]:
                    values[place] = name
        return (
            "SoundEffect(freq_start=%d, freq_end=%d, duration=%d, vol_start=%d, vol_end=%d, waveform=%s, fx=%s, shape=%s)"
            % tuple(values)
        )


_FRAME_SAMPLES = 32
_FRAME_RATE = 7812
_RECORDING_RATE = 11000
_FASTEST = 1000000


def _rate(rate):
    number(rate)
    rate = int(rate)
    if rate <= 0:
        raise ValueError("rate out of bounds")
    return rate


def _size(duration, rate, problem):
    number(duration)
    if duration <= 0:
        raise ValueError(problem)
    return max(1, int(duration * rate / 1000))


def rate_of(source):
    """Samples a second, up to the resolution of the simulation: one a microsecond."""
    return min(source._rate, _FASTEST)


class _Rated:
    def get_rate(self):
        return self._rate

    def set_rate(self, rate):
        put(self, "_rate", _rate(rate))


_SILENCE = b"\x80" * 256


def _short(thing):
    return "<" + type(thing).__name__ + ">"


class _Samples:
    # Samples in memory of its own. No subclass of bytearray: that could not have *=.
    def _fill(self, size, rate):
        # Silence, bit by bit: a recording of 3 s would not fit into memory twice.
        put(self, "_data", memoryview(bytearray(size)))
        for start in range(0, size, len(_SILENCE)):
            self._data[start : start + len(_SILENCE)] = _SILENCE[: size - start]
        put(self, "_rate", rate)
        return self

    def __repr__(self):
        return _short(self)

    def __iter__(self):
        # For bytes(frame): the device takes a frame's buffer there, and has nothing to iterate over.
        return iter(self._data)


class _Sums:
    # Sums and products of frames and tracks; _data is where their samples are, _copy() makes a new one.
    def copyfrom(self, other):
        data = data_of(other)
        count = min(len(self._data), len(data))
        self._data[:count] = data[:count]

    def __iadd__(self, other):
        return _add(self, other, 1)

    def __isub__(self, other):
        return _add(self, other, -1)

    def __add__(self, other):
        return _add(self._copy(), other, 1)

    def __sub__(self, other):
        return _add(self._copy(), other, -1)

    def __mul__(self, factor):
        return _multiply(self._copy(), factor)


def data_of(source):
    """The bytes of anything with a buffer; a track has them too."""
    return source._data if isinstance(source, (_Samples, AudioTrack)) else raw(source)


def _add(target, other, sign):
    if type(other) is not type(target):
        return NotImplemented
    a = target._data
    b = other._data
    _h.samples_add(addressof(a), addressof(b), min(len(a), len(b)), sign)
    return target


def _multiply(target, factor):
    number(factor)
    _h.samples_multiply(addressof(target._data), len(target._data), float(factor))
    return target


class AudioFrame(_Sums, _Samples, _Rated if has_recording else object):
    __setattr__ = refuse_attribute

    def __init__(self, *args, **kwargs):
        self._fill(*_frame_size(*args, **kwargs))

    def __len__(self):
        return len(self._data)

    def _copy(self):
        copy = AudioFrame()._fill(len(self), self._rate)
        copy.copyfrom(self)
        return copy

    def _check(self, index):
        ints(index)
        if not 0 <= index < len(self):
            raise ValueError("index out of bounds")

    def __getitem__(self, index):
        self._check(index)
        return self._data[index]

    def __setitem__(self, index, value):
        self._check(index)
        self._data[index] = _sample(value)

    def __delitem__(self, index):
        self._check(index)
        raise TypeError("cannot delete elements of AudioFrame")


def _sample(value):
    ints(value)
    if not 0 <= value <= 255:
        raise ValueError("value out of range")
    return value


if has_recording:

    def _frame_size(duration=None, rate=_FRAME_RATE):
        rate = _rate(rate)
        return _FRAME_SAMPLES if duration is None else _size(duration, rate, "size out of bounds"), rate

else:

    def _frame_size(*args):
        if args:
            raise TypeError("function takes 0 positional arguments but %d were given" % len(args))
        return _FRAME_SAMPLES, _FRAME_RATE


class AudioRecording(_Samples, _Rated):
    __setattr__ = refuse_attribute

    def __init__(self, duration, rate=_RECORDING_RATE):
        rate = _rate(rate)
        self._fill(_size(duration, rate, "duration out of bounds"), rate)

    def copy(self):
        copy = AudioRecording(1)._fill(len(self._data), self._rate)
        copy._data[:] = self._data
        return copy

    def track(self, *, start_ms=0, end_ms=-1):
        size = len(self._data)
        number(start_ms)
        number(end_ms)
        place = lambda ms: min(max(0, int(ms * self._rate / 1000)), size)
        start = place(start_ms)
        end = size if end_ms == -1 else place(end_ms)
        return AudioTrack(self._data[start : max(start, end)], self._rate)


class AudioTrack(_Sums, _Rated):
    __setattr__ = refuse_attribute

    # Part of a buffer: what is changed here changes there.
    def __init__(self, buffer, rate=_RECORDING_RATE):
        put(self, "_rate", _rate(rate))
        if isinstance(buffer, (str, bytes)):
            # These must not change.
            buffer = bytearray(raw(buffer))
        put(self, "_data", buffer._data if isinstance(buffer, (_Samples, AudioTrack)) else memoryview(buffer))

    def __repr__(self):
        return _short(self)

    def _copy(self):
        # On the device too: the sum of two tracks lies in the memory of the first.
        return AudioTrack(self, self._rate)

    def __len__(self):
        return len(self._data)

    def __getitem__(self, index):
        if isinstance(index, slice):
            return AudioTrack(self._data[index], self._rate)
        return self._data[index]

    def __setitem__(self, index, value):
        self._data[index] = _sample(value)

    def __delitem__(self, index):
        raise TypeError("cannot delete elements of AudioTrack")
