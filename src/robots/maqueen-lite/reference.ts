import { absent, fn, module, type, value } from '#reference/table';
import type { RobotReference } from '#reference/types';
import { drivingNames, tigerJythonNames } from '../library-names';
import words from './words/reference';

/** The names of this robot's libraries (library/*.py) with short descriptions. */
const mbrobot = module('mbrobot', {
  ...drivingNames,
  setSpeed: fn('(speed: int) -> None'),
  resetSpeed: fn('() -> None'),
  delay: fn('(ms: float) -> None'),
  getDistance: fn('() -> int'),
  irLeft: value('IRSensor'),
  irRight: value('IRSensor'),
  motL: value('Motor'),
  motR: value('Motor'),
  setLED: fn('(state: int, stateR: int | None = None) -> None'),
  setLEDLeft: fn('(state: int) -> None'),
  setLEDRight: fn('(state: int) -> None'),
  fillRGB: fn('(red: int, green: int, blue: int) -> None'),
  setRGB: fn('(position: int, red: int, green: int, blue: int) -> None', '(red: int, green: int, blue: int) -> None'),
  posRGB: fn('(position: int, red: int, green: int, blue: int) -> None'),
  clearRGB: fn('() -> None'),
  np_rgb_pixels: value('neopixel.NeoPixel'),
  setServo: fn('(servo: str, angle: int) -> None'),
  setAlarm: fn('(state: int) -> None'),
  beep: fn('() -> None'),
  calibrate: fn('(offset: int, differential: int = 0, arcScaling: float = 0) -> None'),
  ...tigerJythonNames('mbrobot'),
  Motor: type(['(register: int)'], { rotate: fn('(speed: int) -> None') }),
  IRSensor: type(['(pin: Pin)'], { read_digital: fn('() -> int'), read_analog: absent(fn('() -> int')) }),
});

const mbrobotmot = module('mbrobotmot', {
  motL: value('Motor'),
  motR: value('Motor'),
  irLeft: value('MicroBitDigitalPin'),
  irRight: value('MicroBitDigitalPin'),
  ledLeft: value('MicroBitDigitalPin'),
  ledRight: value('MicroBitDigitalPin'),
  setLED: fn('(on: int) -> None'),
  getDistance: fn('() -> int'),
  delay: fn('(ms: float) -> None'),
  Motor: type(['(number: int)'], { rotate: fn('(speed: int) -> None') }),
});

const mbalarm = module('mbalarm', { setAlarm: fn('(on: int) -> None'), beep: fn('() -> None') });

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
