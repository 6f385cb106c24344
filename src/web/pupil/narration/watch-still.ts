import type { Moment } from './moment';

/** Rest after which the tones fall silent, in ms. Chosen: so does a car that parks, once it stands. */
const STILL_AFTER_MS = 3000;

/** Makes a function that is true once nothing has changed for 3 s: neither the robot's place nor what it sees. */
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
