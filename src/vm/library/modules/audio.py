# The module audio. Behaviour and errors: micropython-microbit-v2 modaudio.c; return_pin is there for the micro:bit V1.
import _hal as _h
from _audio import (
    AudioFrame,
    MicroBitSound as _Sound,
    MicroBitSoundEffect as SoundEffect,
    DEFAULT_PIN as _DEFAULT_PIN,
    check as _check,
    has_recording as _has_recording,
    output as _output,
    rate_of as _rate_of,
)
from _sim import addressof as _addressof, raise_in_program as _raise, remember as _remember

_playable = (AudioFrame,)
if _has_recording:
    from _audio import AudioRecording, AudioTrack

    _playable = (AudioFrame, AudioRecording, AudioTrack)

    def sound_level():
        return _h.audio_level()


_frames = None
_takes_return_pin = _h.board_has("return-pin")
_ends_effects = _h.board_has("stop-ends-effects")


def _next_frame():
    """Hands over the next frame; the end of the frames, and an error, end the sound."""
    global _frames
    try:
        frame = next(_frames)
        if not isinstance(frame, _playable):
            raise TypeError("not an AudioFrame")
    except BaseException as error:
        _frames = None
        _h.audio_close()
        if isinstance(error, StopIteration):
            return
        raise
    data = frame._data
    _h.audio_frame(_addressof(data), len(data), _rate_of(frame))


def _next_frame_is_due():
    if _h.audio_frames():
        try:
            _next_frame()
        except BaseException as error:
            _raise(error)


_due = _remember(_next_frame_is_due)


def _effect_of(source):
    """The digits or the name of a sound effect, None for anything else."""
    if isinstance(source, _Sound):
        return source._name
    if isinstance(source, SoundEffect):
        return source._digits
    if isinstance(source, (tuple, list)) and source and isinstance(source[0], SoundEffect):
        return ",".join([effect._digits for effect in source])
    return None


def play(source, wait=True, pin=_DEFAULT_PIN, return_pin=None):
    global _frames
    if return_pin is not None and not _takes_return_pin:
        raise ValueError("return_pin not supported")
    if _h.audio_frames():
        stop()
    _check(_h.audio_pin(_output(pin)))
    effect = _effect_of(source)
    if effect is not None:
        _h.audio_effect(effect)
        if wait:
            try:
                while _h.audio_wait():
                    pass
            except BaseException:
                _h.audio_stop_effect()
                raise
        return
    if isinstance(source, _playable):
        if not _has_recording:
            raise TypeError("'AudioFrame' object isn't iterable")
        source = (source,)
    _frames = iter(source)
    _h.audio_open(_due)
    _next_frame()
    if wait:
        while _h.audio_wait():
            pass


def stop():
    global _frames
    _frames = None
    _h.audio_stop(_ends_effects)


def is_playing():
    return _h.audio_playing()
