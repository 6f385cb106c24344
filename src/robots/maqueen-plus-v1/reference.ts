import { fn, module, range, type, value, values, within } from '#reference/table';
import type { RobotReference } from '#reference/types';
import { delay, drivingNames, servo, switched, tigerJythonNames } from '../library-names';
import words from './words/reference';

const light = within({ state: range(0, 7) }, fn('(state: int) -> None'));

/** The names of this robot's library (library/mbrobot_plus.py) with short descriptions. */
const mbrobotPlus = module('mbrobot_plus', {
  ...drivingNames,
  setSpeed: within({ speed: range(0, 255) }, fn('(speed: int) -> None')),
  resetSpeed: fn('() -> None'),
  setPID: switched('on'),
  delay,
  getDistance: fn('() -> int'),
  ...values('IRSensor', ['irLeft', 'irRight', 'irL1', 'irL2', 'irL3', 'irR1', 'irR2', 'irR3']),
  ir_read_values_as_byte: fn('() -> int'),
  motL: value('Motor'),
  motR: value('Motor'),
  setLED: within({ state: range(0, 7), stateR: range(0, 7) }, fn('(state: int, stateR: int | None = None) -> None')),
  setLEDLeft: light,
  setLEDRight: light,
  setServo: servo,
  setAlarm: switched('on'),
  beep: fn('() -> None'),
  ...tigerJythonNames('mbrobot_plus'),
  Motor: type(['(id: int)'], { rotate: within({ speed: range(-255, 255) }, fn('(speed: int) -> None')) }),
  IRSensor: type(['(index: int)'], { read_digital: fn('() -> int') }),
  IR: type([], { ...values('int', ['L3', 'L2', 'L1', 'R1', 'R2', 'R3']), masks: value('list[int]') }),
  LEDState: type([], values('int', ['OFF', 'RED', 'GREEN', 'YELLOW', 'BLUE', 'PINK', 'CYAN', 'WHITE'])),
});

/** The Maqueen Plus V1's library, for the editor. */
export const maqueenPlusV1Reference: RobotReference = {
  robot: 'maqueen-plus-v1',
  modules: [mbrobotPlus],
  texts: words,
};
