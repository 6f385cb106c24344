import type { Watcher } from './news';

/** Rest after which the robot has stopped, in ms. Chosen: a program waits about a second between two moves. */
const REST_AFTER_MS = 1500;
const STILL_MM = 1;
const STILL_RAD = 0.01;

/** Finds out when the robot has stopped, once after each drive. */
export function watchRest(): Watcher {
  let last: { pathMm: number; turnedRad: number; atMs: number } | null = null;
  let hasMoved = false;
  return (seen) => {
    const { pathMm, turnedRad, atMs } = seen;
    last ??= { pathMm, turnedRad, atMs };
    if (Math.abs(pathMm - last.pathMm) > STILL_MM || Math.abs(turnedRad - last.turnedRad) > STILL_RAD) {
      last = { pathMm, turnedRad, atMs };
      hasMoved = true;
      return [];
    }
    if (!hasMoved || atMs - last.atMs < REST_AFTER_MS) return [];
    hasMoved = false;
    return [{ topic: 'rest', seen }];
  };
}
