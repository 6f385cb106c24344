import { fn, module } from '#reference/table';
import type { RobotReference } from '#reference/types';
import { drivingNames } from '../library-names';
import words from './words/reference';

const arc = fn('(r: float) -> None');
const switched = fn('(on: int) -> None');
const motor = fn('(dir: int, speed: int) -> None');

/** The names of this robot's library (library/callimk.py) with short descriptions. */
const callimk = module('callimk', {
  ...drivingNames,
  leftArc: arc,
  rightArc: arc,
  exit: fn('() -> None'),
  setSpeed: fn('(speed: int) -> None'),
  delay: fn('(ms: float) -> None'),
  motorL: motor,
  motorR: motor,
  w: fn('(d1: int, d2: int, s1: int, s2: int) -> None'),
  setLED: switched,
  setLEDLeft: switched,
  setLEDRight: switched,
  led: fn('(right_left: int, on_off: int) -> None'),
  rgbLED: fn('(red: int, green: int, blue: int) -> None'),
  getDistance: fn('() -> int'),
  irLeftValue: fn('() -> int'),
  irRightValue: fn('() -> int'),
  setServo: fn('(S: str, Angle: int) -> None'),
});

/** The MotionKit 2's library, for the editor. */
export const motionkit2Reference: RobotReference = {
  robot: 'motionkit-2',
  modules: [callimk],
  texts: words,
};
