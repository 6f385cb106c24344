import type { Snapshot } from '#simulation/snapshot';

/**
 * Time for which everything must have looked the same, in µs of simulated time. Chosen: a sinking fork moves in each
 * step.
 */
const STILL_US = 500_000;

/**
 * Detects whether anything in the run still moves. Everything counts: wheels that spin at a wall are seen to turn, and their
 * encoders can be read in the REPL; a robot that is turned by a millionth of a degree in each step slips off in the end.
 */
export interface Stillness {
  /** Takes the next picture. @returns whether all pictures of the last half second were the same */
  look(snapshot: Snapshot): boolean;
  /** Something happens or is scheduled: starts over. @returns false */
  forget(): false;
}

export function createStillness(): Stillness {
  let last = '';
  let sinceUs = 0;
  return {
    look({ timeUs, ...rest }) {
      const now = JSON.stringify(rest);
      if (now !== last) sinceUs = timeUs;
      last = now;
      return timeUs - sinceUs >= STILL_US;
    },
    forget() {
      last = '';
      return false;
    },
  };
}
