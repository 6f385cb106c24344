import { fn, module, range, type, value, within } from '#reference/table';
import type { RobotReference } from '#reference/types';
import { delay, drivingNames, switched } from '../library-names';
import words from './words/reference';

/** The names of this robot's libraries (library/*.py) with short descriptions. */
const callibotModule = module('callibot', {
  ...drivingNames,
  exit: fn('() -> None'),
  setSpeed: within({ speed: range(-200, 200) }, fn('(speed: int) -> None')),
  delay,
  getDistance: fn('() -> float'),
  irLeftValue: fn('() -> int'),
  irRightValue: fn('() -> int'),
  tsValue: fn('() -> int'),
  tsLeftValue: fn('() -> int'),
  tsRightValue: fn('() -> int'),
  setLED: switched('on'),
  setLEDLeft: switched('on'),
  setLEDRight: switched('on'),
  setAlarm: switched('on'),
  motL: value('Motor'),
  motR: value('Motor'),
  irLeft: value('Sensor'),
  irRight: value('Sensor'),
  ts: value('Sensor'),
  tsLeft: value('Sensor'),
  tsRight: value('Sensor'),
  w: fn('(d1: int, d2: int, s1: int, s2: int) -> None'),
  Motor: type(['(register: int)'], { rotate: within({ speed: range(-200, 200) }, fn('(speed: int) -> None')) }),
  Sensor: type(['(bits: int)'], { read_digital: fn('() -> int'), getValue: fn('() -> int') }),
});

const callibotmot = module('callibotmot', {
  motL: value('Motor'),
  motR: value('Motor'),
  setLED: switched('on'),
  delay,
  Motor: type(['(number: int)'], { rotate: within({ speed: range(-200, 200) }, fn('(speed: int) -> None')) }),
});

const cbalarm = module('cbalarm', { setAlarm: switched('on'), beep: fn('() -> None') });

/** The Calli:bot's libraries, for the editor. */
export const callibotReference: RobotReference = {
  robot: 'callibot',
  modules: [callibotModule, callibotmot, cbalarm],
  texts: words,
};
