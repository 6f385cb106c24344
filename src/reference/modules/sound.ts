import { fn, module, newer, type, value, values } from '../table';

/** Sources: micropython-microbit-v2, src/codal_port/modaudio.c, microbit_soundeffect.c, modmusic.c, modspeech.c. */
export const audio = module('audio', {
  play: fn(
    '(source: Sound | SoundEffect | AudioFrame | list, wait: bool = True, pin: Pin = pin0, return_pin: Pin | None = None) -> None',
  ),
  is_playing: fn('() -> bool'),
  stop: fn('() -> None'),
  sound_level: newer('recording', fn('() -> int')),
  SoundEffect: type(
    [
      '(freq_start: int = 500, freq_end: int = 2500, duration: int = 500, vol_start: int = 255, vol_end: int = 0, waveform: int = WAVEFORM_SQUARE, fx: int = FX_NONE, shape: int = SHAPE_LOG)',
    ],
    {
      ...values('int', ['freq_start', 'freq_end', 'duration', 'vol_start', 'vol_end', 'waveform', 'fx', 'shape']),
      copy: fn('() -> SoundEffect'),
      ...values('int', ['WAVEFORM_SINE', 'WAVEFORM_SAWTOOTH', 'WAVEFORM_TRIANGLE', 'WAVEFORM_SQUARE']),
      ...values('int', ['WAVEFORM_NOISE', 'SHAPE_LINEAR', 'SHAPE_CURVE', 'SHAPE_LOG']),
      ...values('int', ['FX_NONE', 'FX_TREMOLO', 'FX_VIBRATO', 'FX_WARBLE']),
      _from_string: fn('(text: str) -> SoundEffect'),
    },
  ),
  AudioFrame: type(['()'], {
    copyfrom: fn('(other: AudioFrame) -> None'),
    get_rate: newer('recording', fn('() -> int')),
    set_rate: newer('recording', fn('(rate: int) -> None')),
  }),
  AudioRecording: newer(
    'recording',
    type(['(duration: float, rate: int = 11000)'], {
      get_rate: fn('() -> int'),
      set_rate: fn('(rate: int) -> None'),
      copy: fn('() -> AudioRecording'),
      track: fn('(*, start_ms: float = 0, end_ms: float = -1) -> AudioTrack'),
    }),
  ),
  AudioTrack: newer(
    'recording',
    type(['(buffer: AudioRecording | bytearray, rate: int = 11000)'], {
      get_rate: fn('() -> int'),
      set_rate: fn('(rate: int) -> None'),
      copyfrom: fn('(other: AudioTrack) -> None'),
    }),
  ),
});

export const music = module('music', {
  play: fn('(music: str | list[str], pin: Pin | None = pin0, wait: bool = True, loop: bool = False) -> None'),
  pitch: fn('(frequency: int, duration: int = -1, pin: Pin | None = pin0, wait: bool = True) -> None'),
  stop: fn('(pin: Pin = pin0, /) -> None'),
  set_tempo: fn('(*, ticks: int = ..., bpm: int = ...) -> None'),
  get_tempo: fn('() -> tuple[int, int]'),
  reset: fn('() -> None'),
  ...values('tuple[str, ...]', ['DADADADUM', 'ENTERTAINER', 'PRELUDE', 'ODE', 'NYAN', 'RINGTONE', 'FUNK', 'BLUES']),
  ...values('tuple[str, ...]', ['BIRTHDAY', 'WEDDING', 'FUNERAL', 'PUNCHLINE', 'PYTHON', 'BADDY', 'CHASE', 'BA_DING']),
  ...values('tuple[str, ...]', ['WAWAWAWAA', 'JUMP_UP', 'JUMP_DOWN', 'POWER_UP', 'POWER_DOWN']),
});

export const speech = module('speech', {
  say: fn(
    '(words: str, *, pitch: int = 64, speed: int = 72, mouth: int = 128, throat: int = 128, pin: Pin = pin0) -> None',
  ),
  pronounce: fn(
    '(phonemes: str, *, pitch: int = 64, speed: int = 72, mouth: int = 128, throat: int = 128, pin: Pin = pin0) -> None',
  ),
  sing: fn(
    '(phonemes: str, *, pitch: int = 64, speed: int = 72, mouth: int = 128, throat: int = 128, pin: Pin = pin0) -> None',
  ),
  translate: fn('(words: str) -> str'),
});

/** Source: micropython-microbit-v2, src/codal_port/modules/neopixel.py. */
export const neopixel = module('neopixel', {
  NeoPixel: type(['(pin: Pin, n: int, bpp: int = 3)'], {
    show: fn('() -> None'),
    write: fn('() -> None'),
    fill: fn('(colour: tuple[int, int, int]) -> None'),
    clear: fn('() -> None'),
    n: value('int'),
    bpp: value('int'),
  }),
});
