# The microphone. Names and errors: micropython-microbit-v2 microbit_microphone.c, microbit_soundevent.c.
import _hal
from _audio import AudioFrame, AudioRecording, AudioTrack, rate_of
from _sim import addressof, ints, number, put, refuse_attribute

_has = _hal.board_has
_level = _hal.mic_level


class MicroBitSoundEvent:
    __setattr__ = refuse_attribute

    def __init__(self, name):
        put(self, "_name", name)

    def __repr__(self):
        return "SoundEvent('" + self._name + "')"


_loud = MicroBitSoundEvent.LOUD = MicroBitSoundEvent("loud")
_quiet = MicroBitSoundEvent.QUIET = MicroBitSoundEvent("quiet")
_events = {"loud": _loud, "quiet": _quiet}
if _has("clap"):
    MicroBitSoundEvent.CLAP = _events["clap"] = MicroBitSoundEvent("clap")


def _name(event):
    if not isinstance(event, MicroBitSoundEvent):
        raise ValueError("invalid sound")
    return event._name


_RATE = 11000
# The buffer of a recording: kept, so that it is not collected before the recording ends.
_buffer = None


def _record(buffer, rate, wait):
    global _buffer
    number(rate)
    buffer.set_rate(rate)
    _buffer = data = buffer._data
    _hal.mic_record(addressof(data), len(data), rate_of(buffer))
    try:
        # A callback in between ends the syscall early: wait on.
        while wait and _hal.mic_recorded():
            pass
    except BaseException:
        _hal.mic_stop()
        raise


class MicroBitMicrophone:
    __setattr__ = refuse_attribute

    def __repr__(self):
        return "<MicroBitMicrophone>"

    def set_threshold(self, event, value):
        if event is not _loud and event is not _quiet:
            raise ValueError("invalid sound")
        ints(value)
        _hal.mic_threshold(event._name, value)

    def sound_level(self):
        return _level()

    if _has("sound-level-db"):

        def sound_level_db(self):
            return float(_hal.mic_level_db())

    def current_event(self):
        return _events[_hal.mic_event()]

    def is_event(self, event):
        return _hal.mic_event() == _name(event)

    def was_event(self, event):
        return _hal.mic_was(_name(event))

    def get_events(self):
        heard = _hal.mic_events()
        return tuple([_events[name] for name in heard.split("\n")]) if heard else ()

    if _has("recording"):
        SENSITIVITY_LOW = 0.079
        SENSITIVITY_MEDIUM = 0.2
        SENSITIVITY_HIGH = 1.0

        def set_sensitivity(self, gain):
            number(gain)
            _hal.mic_sensitivity(float(gain))

        def record(self, duration, rate=_RATE):
            recording = AudioRecording(duration, rate)
            _record(recording, rate, True)
            return recording

        def record_into(self, buffer, rate=_RATE, wait=True):
            if not isinstance(buffer, (AudioRecording, AudioTrack, AudioFrame)):
                raise TypeError("expecting an AudioRecording or AudioTrack")
            _record(buffer, rate, wait)
            # Stopped early, the track has what was recorded.
            return AudioTrack(buffer._data[: _hal.mic_count()] if wait else buffer._data, rate)

        def is_recording(self):
            return _hal.mic_is_recording()

        def stop_recording(self):
            _hal.mic_stop()
