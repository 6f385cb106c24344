import { fn, module, range, within } from '#reference/table';
import type { RobotReference } from '#reference/types';
import { drivingNames } from '../library-names';
import words from './words/reference';

/** The names of this robot's library (library/mbbitbot.py) with short descriptions. */
const mbbitbot = module('mbbitbot', {
  ...drivingNames,
  setSpeed: within({ percent: range(0, 100) }, fn('(percent: float) -> None')),
  calibrate: fn('(offset: int, differential: int = 0) -> None'),
  w: fn('(leftforward: float, leftbackward: float, rightforward: float, rightbackward: float) -> None'),
  getDistance: fn('() -> int'),
  getLine: fn('(bit: int) -> int'),
  getLight: fn('(index: int) -> int'),
  set_led: fn('(pos: int, red: int, green: int, blue: int) -> None'),
  fill: fn('(red: int, green: int, blue: int) -> None'),
});

/** The bit:bot XL's library, for the editor. */
export const bitbotXlReference: RobotReference = {
  robot: 'bitbot-xl',
  modules: [mbbitbot],
  texts: words,
  misnamed: { left: 'right', right: 'left' },
};
