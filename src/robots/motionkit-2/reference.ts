import { fn, module, range, within } from '#reference/table';
import type { RobotReference } from '#reference/types';
import { color, delay, drivingNames, metres, switched } from '../library-names';
import words from './words/reference';

const arc = within({ r: metres }, fn('(r: float) -> None'));
const motor = fn('(dir: int, speed: int) -> None');

/** The names of this robot's library (library/callimk.py) with short descriptions. */
const callimk = module('callimk', {
  ...drivingNames,
  leftArc: arc,
  rightArc: arc,
  exit: fn('() -> None'),
  setSpeed: within({ speed: range(0, 255) }, fn('(speed: int) -> None')),
  delay,
  motorL: motor,
  motorR: motor,
  w: fn('(d1: int, d2: int, s1: int, s2: int) -> None'),
  setLED: switched('on'),
  setLEDLeft: switched('on'),
  setLEDRight: switched('on'),
  led: fn('(right_left: int, on_off: int) -> None'),
  rgbLED: within(color, fn('(red: int, green: int, blue: int) -> None')),
  getDistance: fn('() -> int'),
  irLeftValue: fn('() -> int'),
  irRightValue: fn('() -> int'),
  setServo: within({ Angle: range(0, 180) }, fn('(S: str, Angle: int) -> None')),
});

/** The MotionKit 2's library, for the editor. */
export const motionkit2Reference: RobotReference = {
  robot: 'motionkit-2',
  modules: [callimk],
  texts: words,
};
