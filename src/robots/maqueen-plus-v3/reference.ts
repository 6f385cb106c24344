import { fn, module, range, type, value, within } from '#reference/table';
import type { RobotReference } from '#reference/types';
import { color, delay, drivingNames, servo, switched, tigerJythonNames } from '../library-names';
import words from './words/reference';

const NAME = 'mbrobot_plusV3';

/** The names of this robot's library (library/*.py) with short descriptions. */
const mbrobotPlusV3 = module(NAME, {
  ...drivingNames,
  setSpeed: within({ speed: range(0, 100) }, fn('(speed: int) -> None')),
  resetSpeed: fn('() -> None'),
  delay,
  motL: value('Motor'),
  motR: value('Motor'),
  pidControlDistance: fn('(dir: int, distance: int, interruption: int) -> None'),
  pidControlAngle: fn('(angle: int, interruption: int) -> None'),
  pidControlStop: fn('() -> None'),
  readRealTimeSpeed: fn('(type: int) -> float'),
  setPatrolSpeed: fn('(speed: int) -> None'),
  patrolling: fn('(patrol: int) -> None'),
  setIntersectionRunMode: fn('(mode: int) -> None'),
  setTRordRunMode: fn('(mode: int) -> None'),
  setLeftOrStraightRunMode: fn('(mode: int) -> None'),
  setRightOrStraightRunMode: fn('(mode: int) -> None'),
  intersectionDetecting: fn('() -> int'),
  setServo: servo,
  irL2: value('IRSensor'),
  irL1: value('IRSensor'),
  irM: value('IRSensor'),
  irR1: value('IRSensor'),
  irR2: value('IRSensor'),
  irLeft: value('IRSensor'),
  irRight: value('IRSensor'),
  readLightIntensity: fn('(side: int) -> int'),
  setLidarMode: fn('(mode: int = 8) -> None'),
  getDistance: fn('() -> int'),
  getDistanceAt: fn('(x_pos: int, y_pos: int) -> int'),
  getDistanceList: fn('() -> list[int]'),
  getDistanceGrid: fn('() -> list[list[int]]'),
  getDistanceColumn: fn('(index: int) -> list[int]'),
  getDistanceRow: fn('(index: int) -> list[int]'),
  setLEDs: within({ rgbl: range(0, 7), rgbr: range(0, 7) }, fn('(rgbl: int, rgbr: int) -> None')),
  setLED: within({ rgb: range(0, 7) }, fn('(rgb: int) -> None')),
  setLEDLeft: within({ rgbl: range(0, 7) }, fn('(rgbl: int) -> None')),
  setLEDRight: within({ rgbr: range(0, 7) }, fn('(rgbr: int) -> None')),
  fillRGB: within(color, fn('(red: int, green: int, blue: int) -> None')),
  setRGB: fn('(r: int, g: int, b: int) -> None'),
  posRGB: fn('(position: int, red: int, green: int, blue: int) -> None'),
  clearRGB: fn('() -> None'),
  setAlarm: switched('state'),
  beep: fn('() -> None'),
  Motor: type(['(register: int)'], { rotate: within({ speed: range(-100, 100) }, fn('(speed: int) -> None')) }),
  IRSensor: type(['(index: int)'], {
    index: value('int'),
    read_digital: fn('() -> int'),
    read_analog: fn('() -> int'),
  }),
  ...tigerJythonNames(NAME),
});

/** The Maqueen Plus V3's library, for the editor. */
export const maqueenPlusV3Reference: RobotReference = {
  robot: 'maqueen-plus-v3',
  modules: [mbrobotPlusV3],
  texts: words,
};
