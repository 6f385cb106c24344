import { fn, module, range, type, value, within, withWordsOf } from '#reference/table';
import type { RobotReference } from '#reference/types';
import { color, delay, drivingNames, servo, switched, tigerJythonNames } from '../library-names';
import words from './words/reference';

const NAME = 'mbrobot_plusV2';

/** The names of this robot's library (library/*.py) with short descriptions. */
const mbrobotPlusV2 = module(NAME, {
  ...drivingNames,
  setSpeed: within({ speed: range(0, 100) }, fn('(speed: int) -> None')),
  resetSpeed: fn('() -> None'),
  delay,
  getDistance: fn('() -> int'),
  irL2: value('IRSensor'),
  irL1: value('IRSensor'),
  irM: value('IRSensor'),
  irR1: value('IRSensor'),
  irR2: value('IRSensor'),
  irLeft: value('IRSensor'),
  irRight: value('IRSensor'),
  ir_read_values_as_byte: fn('() -> int'),
  motL: value('Motor'),
  motR: value('Motor'),
  setLED: within({ state: range(0, 1), stateR: range(0, 1) }, fn('(state: int, stateR: int | None = None) -> None')),
  setLEDLeft: switched('state'),
  setLEDRight: switched('state'),
  fillRGB: within(color, fn('(red: int, green: int, blue: int) -> None')),
  setRGB: fn('(red: int, green: int, blue: int) -> None', '(position: int, red: int, green: int, blue: int) -> None'),
  posRGB: fn('(position: int, red: int, green: int, blue: int) -> None'),
  clearRGB: fn('() -> None'),
  np_rgb_pixels: value('neopixel.NeoPixel'),
  setServo: servo,
  setMinServoDuty: fn('(duty: int) -> None'),
  setMaxServoDuty: fn('(duty: int) -> None'),
  setMinAngleVal: withWordsOf(`${NAME}.setMinServoDuty`, fn('(duty: int) -> None')),
  setMaxAngleVal: withWordsOf(`${NAME}.setMaxServoDuty`, fn('(duty: int) -> None')),
  setAlarm: switched('state'),
  beep: fn('() -> None'),
  calibrate: fn('(offset: int, differential: int = 0, arcScaling: float = 0) -> None'),
  Motor: type(['(register: int)'], { rotate: within({ speed: range(-100, 100) }, fn('(speed: int) -> None')) }),
  IRSensor: type(['(index: int)'], { read_digital: fn('() -> int'), read_analog: fn('() -> int') }),
  IR: type([], {
    R2: value('int'),
    R1: value('int'),
    M: value('int'),
    L1: value('int'),
    L2: value('int'),
    masks: value('list'),
  }),
  LEDState: type([], { OFF: value('int'), ON: value('int'), RED: value('int') }),
  ...tigerJythonNames(NAME),
});

/** The Maqueen Plus V2's library, for the editor. */
export const maqueenPlusV2Reference: RobotReference = {
  robot: 'maqueen-plus-v2',
  modules: [mbrobotPlusV2],
  texts: words,
};
