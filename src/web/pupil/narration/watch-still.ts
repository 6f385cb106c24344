import type { Moment } from './moment';

/** Chosen: a car that parks falls silent, too, once it stands. */
const STILL_AFTER_MS = 3000;

/** True if nothing has changed for some seconds: neither the robot's place nor what it sees. */
export function watchStill(): (moment: Moment) => boolean {
  let before = '';
  let sinceMs = 0;
  return ({ pose, ahead, lineSensors, atMs }) => {
    const place = [pose.xMm, pose.yMm, 100 * pose.headingRad, ahead?.mm ?? 0].map(Math.round);
    const now = [...place, ...lineSensors.map(({ isDark }) => isDark)].join();
    if (now !== before) [before, sinceMs] = [now, atMs];
    return atMs - sinceMs >= STILL_AFTER_MS;
  };
}
