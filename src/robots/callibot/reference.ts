import { fn, module, type, value } from '#reference/table';
import type { RobotReference } from '#reference/types';
import { drivingNames } from '../library-names';
import words from './words/reference';

/** The names of this robot's libraries (library/*.py) with short descriptions. */
const callibotModule = module('callibot', {
  ...drivingNames,
  exit: fn('() -> None'),
  setSpeed: fn('(speed: int) -> None'),
  delay: fn('(ms: float) -> None'),
  getDistance: fn('() -> float'),
  irLeftValue: fn('() -> int'),
  irRightValue: fn('() -> int'),
  tsValue: fn('() -> int'),
  tsLeftValue: fn('() -> int'),
  tsRightValue: fn('() -> int'),
  setLED: fn('(on: int) -> None'),
  setLEDLeft: fn('(on: int) -> None'),
  setLEDRight: fn('(on: int) -> None'),
  setAlarm: fn('(on: int) -> None'),
  motL: value('Motor'),
  motR: value('Motor'),
  irLeft: value('Sensor'),
  irRight: value('Sensor'),
  ts: value('Sensor'),
  tsLeft: value('Sensor'),
  tsRight: value('Sensor'),
  w: fn('(d1: int, d2: int, s1: int, s2: int) -> None'),
  Motor: type(['(register: int)'], { rotate: fn('(speed: int) -> None') }),
  Sensor: type(['(bits: int)'], { read_digital: fn('() -> int'), getValue: fn('() -> int') }),
});

const callibotmot = module('callibotmot', {
  motL: value('Motor'),
  motR: value('Motor'),
  setLED: fn('(on: int) -> None'),
  delay: fn('(ms: float) -> None'),
  Motor: type(['(number: int)'], { rotate: fn('(speed: int) -> None') }),
});

const cbalarm = module('cbalarm', { setAlarm: fn('(on: int) -> None'), beep: fn('() -> None') });

/** The Calli:bot's libraries, for the editor. */
export const callibotReference: RobotReference = {
  robot: 'callibot',
  modules: [callibotModule, callibotmot, cbalarm],
  texts: words,
};
