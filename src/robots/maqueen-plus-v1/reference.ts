import { fn, module, type, value, values } from '#reference/table';
import type { RobotReference } from '#reference/types';
import { drivingNames, tigerJythonNames } from '../library-names';
import words from './words/reference';

/** The names of this robot's library (library/mbrobot_plus.py) with short descriptions. */
const mbrobotPlus = module('mbrobot_plus', {
  ...drivingNames,
  setSpeed: fn('(speed: int) -> None'),
  resetSpeed: fn('() -> None'),
  setPID: fn('(on: int) -> None'),
  delay: fn('(ms: float) -> None'),
  getDistance: fn('() -> int'),
  ...values('IRSensor', ['irLeft', 'irRight', 'irL1', 'irL2', 'irL3', 'irR1', 'irR2', 'irR3']),
  ir_read_values_as_byte: fn('() -> int'),
  motL: value('Motor'),
  motR: value('Motor'),
  setLED: fn('(state: int, stateR: int | None = None) -> None'),
  setLEDLeft: fn('(state: int) -> None'),
  setLEDRight: fn('(state: int) -> None'),
  setServo: fn('(servo: str, angle: int) -> None'),
  setAlarm: fn('(on: int) -> None'),
  beep: fn('() -> None'),
  ...tigerJythonNames('mbrobot_plus'),
  Motor: type(['(id: int)'], { rotate: fn('(speed: int) -> None') }),
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
