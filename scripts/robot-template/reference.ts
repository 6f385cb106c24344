import { fn, module } from '#reference/table';
import type { RobotReference } from '#reference/types';
import words from './words/reference';

/** The names of this robot's library (library/new_robot.py) and short words on each. */
const library = module('new_robot', {
  motors: fn('(left: int, right: int) -> None'),
  forward: fn('() -> None'),
  left: fn('() -> None'),
  right: fn('() -> None'),
  stop: fn('() -> None'),
  setLED: fn('(on: int) -> None'),
  isLight: fn('() -> int'),
});

/** The New Robot's library, for the editor. */
export const newRobotReference: RobotReference = {
  robot: 'new-robot',
  modules: [library],
  texts: words,
};
