import type { Scene } from '#scene/scene';
import type { Check, Fact } from '../task/task';
import { watchEarly, watchGoals, watchTime, watchTouches } from './watch-goals';
import { watchConsole, watchDisplay, watchLight, watchLog, watchRadio, watchSound } from './watch-shows';
import { watchScore, watchTiles } from './watch-line';
import { watchBelongs, watchCovered } from './watch-things';
import { watchCheckpoints, watchLaps, watchReach, watchStay, watchStop } from './watch-way';
import type { Watcher } from './watcher';

/** A check that a run decides. */
export type RunCheck = Exclude<Check, Fact>;

/** Returns the watcher for a check. */
export function watcherOf(check: RunCheck, course: Scene): Watcher {
  switch (check.type) {
    case 'goals':
      return watchGoals(course);
    case 'stop':
      return watchStop(course, check);
    case 'reach':
      return watchReach(course, check.zones);
    case 'stay':
      return watchStay(course, check);
    case 'belongs':
      return watchBelongs(course, check);
    case 'covered':
      return watchCovered(course, check);
    case 'laps':
      return watchLaps(course, check.count);
    case 'checkpoints':
      return watchCheckpoints(course);
    case 'tiles':
      return watchTiles(check.count);
    case 'score':
      return watchScore(check.least);
    case 'touches':
      return watchTouches(check.most);
    case 'faster':
      return watchTime(check.seconds);
    case 'later':
      return watchEarly(check.seconds);
    case 'display':
      return watchDisplay(check.image);
    case 'light':
      return watchLight(check.which, check.color);
    case 'sound':
      return watchSound(check.hz);
    case 'console':
      return watchConsole(check.text);
    case 'radio':
      return watchRadio(check.text);
    case 'log':
      return watchLog(check.rows, check.column);
  }
}
