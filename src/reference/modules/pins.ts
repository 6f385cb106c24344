import { absent, fn, newer, onlyOn, withWordsOf, type, value, values } from '../table';
import type { Entry, Names } from '../types';

/**
 * The kinds of pins and the pins of both boards.
 * Source: micropython-microbit-v2 and micropython-calliope-mini-v3, src/codal_port/microbit_pin.c and modmicrobit.c.
 */
const microbitAlone = onlyOn.bind(null, 'microbit-v2');
const calliopeAlone = onlyOn.bind(null, 'calliope-mini-3');

const digital: Names = {
  ...values('int', ['NO_PULL', 'PULL_UP', 'PULL_DOWN']),
  read_digital: fn('() -> int'),
  write_digital: fn('(value: int) -> None'),
  write_analog: fn('(value: int) -> None'),
  set_analog_period: fn('(period: int) -> None'),
  set_analog_period_microseconds: fn('(period: int) -> None'),
  get_analog_period_microseconds: fn('() -> int'),
  set_pull: fn('(value: int) -> None'),
  get_pull: fn('() -> int'),
  get_mode: fn('() -> str'),
};

const touch: Names = {
  ...values('int', ['CAPACITIVE', 'RESISTIVE']),
  is_touched: fn('() -> bool'),
  was_touched: newer('touch-counts', fn('() -> bool')),
  get_touches: newer('touch-counts', fn('() -> int')),
  touch_calibrate: newer('touch-counts', fn('() -> None')),
  set_touch_mode: fn('(value: int) -> None'),
};

const analog: Names = { read_analog: fn('() -> int') };

const pinOf = (kind: string): Entry => value(`MicroBit${kind}Pin`);
const pins = (kind: string, names: readonly string[]): Names =>
  Object.fromEntries(names.map((name) => [name, pinOf(kind)]));

/** Names of `microbit` and `calliopemini`. */
export const pinNames: Names = {
  // Programs meet these types, but the module does not hand them out.
  MicroBitDigitalPin: absent(type([], digital)),
  MicroBitAnalogDigitalPin: absent(type([], analog, 'MicroBitDigitalPin')),
  MicroBitTouchOnlyPin: absent(type([], touch)),
  MicroBitTouchPin: absent(type([], {}, 'MicroBitAnalogDigitalPin', 'MicroBitTouchOnlyPin')),
  ...pins('Touch', ['pin0', 'pin1', 'pin2']),
  ...pins('AnalogDigital', ['pin4', 'pin10']),
  ...pins(
    'Digital',
    [5, 6, 7, 8, 9, 11, 12, 13, 14, 15].map((number) => `pin${number}`),
  ),
  pin_logo: pinOf('TouchOnly'),
  pin_speaker: pinOf('Digital'),
  ...microbitAlone({
    pin3: pinOf('AnalogDigital'),
    pin16: pinOf('Digital'),
    pin19: pinOf('Digital'),
    pin20: pinOf('Digital'),
  }),
};

/** The pins that the Calliope mini has instead or in addition. */
export const calliopePinNames: Names = calliopeAlone({
  pin3: withWordsOf('calliopemini.pin3', pinOf('Touch')),
  ...pins('Digital', ['pin18', 'pin_RGB', 'pin_M0_DIR', 'pin_M0_SPEED', 'pin_M1_DIR', 'pin_M1_SPEED', 'pin_M_MODE']),
  ...pins('Digital', ['pin_A0_SCL', 'pin_A0_SDA', 'pin_A1_TX']),
  pin_A1_RX: pinOf('AnalogDigital'),
  // Type hints list them; the firmware has no such names.
  pin16: absent(withWordsOf('calliopemini.pin16', pinOf('Digital'))),
  pin17: absent(withWordsOf('calliopemini.pin16', pinOf('Digital'))),
  pin19: absent(withWordsOf('calliopemini.pin16', pinOf('Digital'))),
  pin20: absent(withWordsOf('calliopemini.pin16', pinOf('Digital'))),
});
