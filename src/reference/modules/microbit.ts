import { absent, fn, moduleNamed, newer, object, withWordsOf, type, value, values, within } from '../table';
import type { Entry, Names, ReferenceModule } from '../types';
import { image } from './images';
import { calliopePinNames, pinNames } from './pins';

/**
 * The board's own module. Sources: micropython-microbit-v2, src/codal_port/modmicrobit.c, microbit_*.c;
 * micropython-microbit-stubs and calliope-edu/micropython-calliope-stubs (parameters).
 */
const display = object({
  show: fn(
    '(image: Image | str | float | list, delay: int = 400, *, wait: bool = True, loop: bool = False, clear: bool = False) -> None',
  ),
  scroll: fn(
    '(text: str | float, delay: int = 150, *, wait: bool = True, loop: bool = False, monospace: bool = False) -> None',
  ),
  clear: fn('() -> None'),
  get_pixel: fn('(x: int, y: int) -> int'),
  set_pixel: fn('(x: int, y: int, value: int) -> None'),
  read_light_level: fn('() -> int'),
  on: fn('() -> None'),
  off: fn('() -> None'),
  is_on: fn('() -> bool'),
  rotate: newer('rotate', fn('(angle: int) -> None')),
});

const accelerometer = object({
  get_x: fn('() -> int'),
  get_y: fn('() -> int'),
  get_z: fn('() -> int'),
  get_values: fn('() -> tuple[int, int, int]'),
  get_strength: fn('() -> int'),
  current_gesture: fn('() -> str'),
  is_gesture: fn('(name: str) -> bool'),
  was_gesture: fn('(name: str) -> bool'),
  get_gestures: fn('() -> tuple[str, ...]'),
  set_range: fn('(value: int) -> None'),
});

const compass = object({
  calibrate: fn('() -> None'),
  is_calibrated: fn('() -> bool'),
  clear_calibration: fn('() -> None'),
  heading: fn('() -> int'),
  get_x: fn('() -> int'),
  get_y: fn('() -> int'),
  get_z: fn('() -> int'),
  get_field_strength: fn('() -> int'),
});

const microphone = object({
  current_event: fn('() -> SoundEvent | None'),
  was_event: fn('(event: SoundEvent) -> bool'),
  is_event: fn('(event: SoundEvent) -> bool'),
  get_events: fn('() -> tuple[SoundEvent, ...]'),
  set_threshold: fn('(event: SoundEvent, value: int) -> None'),
  sound_level: fn('() -> int'),
  sound_level_db: newer('sound-level-db', fn('() -> float')),
  record: newer('recording', fn('(duration: int, rate: int = 11000) -> audio.AudioRecording')),
  record_into: newer(
    'recording',
    fn('(buffer: audio.AudioRecording, rate: int = 11000, wait: bool = True) -> audio.AudioTrack'),
  ),
  is_recording: newer('recording', fn('() -> bool')),
  stop_recording: newer('recording', fn('() -> None')),
  set_sensitivity: newer('recording', fn('(gain: float) -> None')),
  SENSITIVITY_LOW: newer('recording', value('float')),
  SENSITIVITY_MEDIUM: newer('recording', value('float')),
  SENSITIVITY_HIGH: newer('recording', value('float')),
});

const i2c = object({
  init: fn('(freq: int = 100000, sda: Pin = pin20, scl: Pin = pin19) -> None'),
  scan: fn('() -> list[int]'),
  read: fn('(addr: int, n: int, repeat: bool = False) -> bytes'),
  write: fn('(addr: int, buf: bytes, repeat: bool = False) -> None'),
});

const spi = object({
  init: fn(
    '(baudrate: int = 1000000, bits: int = 8, mode: int = 0, sclk: Pin = pin13, mosi: Pin = pin15, miso: Pin = pin14) -> None',
  ),
  read: fn('(nbytes: int, out: int = 0, /) -> bytes'),
  write: fn('(buffer: bytes) -> None'),
  write_readinto: fn('(out: bytes, in_: bytearray) -> None'),
});

const uart = object({
  ...values('int', ['ODD', 'EVEN']),
  init: fn(
    '(baudrate: int = 9600, bits: int = 8, parity: int | None = None, stop: int = 1, *, tx: Pin | None = None, rx: Pin | None = None) -> None',
  ),
  any: fn('() -> bool'),
  read: fn('(nbytes: int | None = None, /) -> bytes | None'),
  readinto: fn('(buf: bytearray, nbytes: int | None = None, /) -> int | None'),
  readline: fn('() -> bytes | None'),
  write: fn('(buf: str | bytes) -> int | None'),
});

const common: Names = {
  display,
  button_a: value('Button'),
  button_b: value('Button'),
  accelerometer,
  compass,
  microphone,
  speaker: object({ on: fn('() -> None'), off: fn('() -> None') }),
  audio: moduleNamed('audio'),
  i2c,
  spi,
  uart,
  sleep: within({ ms: { least: 0 } }, fn('(ms: float) -> None')),
  running_time: fn('() -> int'),
  run_every: fn(
    '(callback: function | None = None, *, days: int = 0, h: int = 0, min: int = 0, s: int = 0, ms: int = 0)',
  ),
  temperature: fn('() -> int'),
  scale: fn('(value: float, *, from_: tuple[float, float], to: tuple[float, float]) -> float'),
  set_volume: fn('(v: int) -> None'),
  panic: fn('(n: int = 999, /) -> None'),
  reset: fn('() -> None'),
  ws2812_write: fn('(pin: Pin, buf: bytes) -> None'),
  Image: image,
  Sound: type(
    [],
    values('Sound', ['GIGGLE', 'HAPPY', 'HELLO', 'MYSTERIOUS', 'SAD', 'SLIDE', 'SOARING', 'SPRING', 'TWINKLE', 'YAWN']),
  ),
  SoundEvent: type([], {
    ...values('SoundEvent', ['LOUD', 'QUIET']),
    CLAP: newer('clap', value('SoundEvent')),
  }),
  // Programs meet this type, but the module does not hand it out.
  Button: absent(
    type([], { is_pressed: fn('() -> bool'), was_pressed: fn('() -> bool'), get_presses: fn('() -> int') }),
  ),
  ...pinNames,
};

/** `microbit` as a micro:bit V2 has it. */
export const microbit: ReferenceModule = { name: 'microbit', aliases: [], boards: ['microbit-v2'], names: common };

/** `calliopemini`; its names say the same as those of `microbit`, from which the words come. */
export const calliopemini: ReferenceModule = {
  name: 'calliopemini',
  aliases: ['microbit'],
  boards: ['calliope-mini-3'],
  names: {
    ...common,
    ...calliopePinNames,
    i2c: {
      ...i2c,
      members: {
        ...i2c.members,
        init: fn('(freq: int = 100000, sda: Pin = pin_A0_SDA, scl: Pin = pin_A0_SCL) -> None'),
      },
    },
  },
};

const samePin = (name: string, kind = 'Touch'): Entry => withWordsOf(name, value(`MicroBit${kind}Pin`));
const oldPin = (number: 0 | 1 | 2 | 3): Entry => samePin(number === 3 ? 'calliopemini.pin3' : `microbit.pin${number}`);
const number = fn('(value: int) -> None');

/**
 * The module of programs for the Calliope mini 1 and 2: all of `calliopemini`, and names that only those boards had.
 * Source: calliope-mini/calliope-mini-micropython, source/microbit/modmicrobit.cpp and calliopeled.cpp.
 */
export const calliopeMini: ReferenceModule = {
  name: 'calliope_mini',
  aliases: [],
  boards: ['calliope-mini-3'],
  names: {
    ...Object.fromEntries(Object.entries(calliopemini.names).filter(([, entry]) => entry.absent !== true)),
    led: object({
      set_colors: fn('(red: int, green: int, blue: int) -> None'),
      set_red: number,
      set_green: number,
      set_blue: number,
      get_colors: fn('() -> tuple[int, int, int]'),
      get_red: fn('() -> int'),
      get_green: fn('() -> int'),
      get_blue: fn('() -> int'),
      clear: fn('() -> None'),
    }),
    p0: oldPin(0),
    p1: oldPin(1),
    p2: oldPin(2),
    p3: oldPin(3),
    c0: oldPin(0),
    c1: oldPin(1),
    c2: oldPin(2),
    c3: oldPin(3),
    c16: samePin('microbit.pin_A1_RX', 'AnalogDigital'),
    c17: samePin('microbit.pin_A1_TX', 'Digital'),
    c18: samePin('microbit.pin_A0_SDA', 'Digital'),
    c19: samePin('microbit.pin_A0_SCL', 'Digital'),
    pin19: samePin('microbit.pin_A0_SCL', 'Digital'),
    pin20: samePin('microbit.pin_A0_SDA', 'Digital'),
  },
};
