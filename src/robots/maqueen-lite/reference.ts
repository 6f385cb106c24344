import { absent, fn, module, range, type, value, within } from '#reference/table';
import type { RobotReference } from '#reference/types';
import { color, delay, drivingNames, servo, switched, tigerJythonNames } from '../library-names';
import words from './words/reference';

/** The names of this robot's libraries (library/*.py) with short descriptions. */
const mbrobot = module('mbrobot', {
  ...drivingNames,
  setSpeed: within({ speed: range(0, 100) }, fn('(speed: int) -> None')),
  resetSpeed: fn('() -> None'),
  delay,
  getDistance: fn('() -> int'),
  irLeft: value('IRSensor'),
  irRight: value('IRSensor'),
  motL: value('Motor'),
  motR: value('Motor'),
  setLED: within({ state: range(0, 1), stateR: range(0, 1) }, fn('(state: int, stateR: int | None = None) -> None')),
  setLEDLeft: switched('state'),
  setLEDRight: switched('state'),
  fillRGB: within(color, fn('(red: int, green: int, blue: int) -> None')),
  setRGB: fn('(position: int, red: int, green: int, blue: int) -> None', '(red: int, green: int, blue: int) -> None'),
  posRGB: fn('(position: int, red: int, green: int, blue: int) -> None'),
  clearRGB: fn('() -> None'),
  np_rgb_pixels: value('neopixel.NeoPixel'),
  setServo: servo,
  setAlarm: switched('state'),
  beep: fn('() -> None'),
  calibrate: fn('(offset: int, differential: int = 0, arcScaling: float = 0) -> None'),
  ...tigerJythonNames('mbrobot'),
  Motor: type(['(register: int)'], { rotate: within({ speed: range(-100, 100) }, fn('(speed: int) -> None')) }),
  IRSensor: type(['(pin: Pin)'], { read_digital: fn('() -> int'), read_analog: absent(fn('() -> int')) }),
});

const mbrobotmot = module('mbrobotmot', {
  motL: value('Motor'),
  motR: value('Motor'),
  irLeft: value('MicroBitDigitalPin'),
  irRight: value('MicroBitDigitalPin'),
  ledLeft: value('MicroBitDigitalPin'),
  ledRight: value('MicroBitDigitalPin'),
  setLED: switched('on'),
  getDistance: fn('() -> int'),
  delay,
  Motor: type(['(number: int)'], { rotate: within({ speed: range(-100, 100) }, fn('(speed: int) -> None')) }),
});

const mbalarm = module('mbalarm', { setAlarm: switched('on'), beep: fn('() -> None') });

const mbled = module('mbled', {
  fill: fn('(red: int, green: int, blue: int) -> None'),
  set_led: fn('(pos: int, red: int, green: int, blue: int) -> None'),
  clear: fn('() -> None'),
  shift_by: fn('(amount: int) -> None'),
  lerp_RGB: fn('(r1: int, g1: int, b1: int, r2: int, g2: int, b2: int, percent: float) -> tuple[int, int, int]'),
});

/** The Maqueen Lite's libraries, for the editor. */
export const maqueenLiteReference: RobotReference = {
  robot: 'maqueen-lite',
  modules: [mbrobot, mbrobotmot, mbalarm, mbled],
  texts: words,
};
