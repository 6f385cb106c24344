import type { News, Watcher } from './news';

const DEGREE = Math.PI / 180;
/** Smallest turn that is announced, in rad. Chosen: less is how a robot sways along a line. */
const LEAST_RAD = 25 * DEGREE;
/** Angle back from which it counts as another turn, in rad. */
const BACK_RAD = 10 * DEGREE;
/** Smallest rotation between two moments that counts, in rad. */
const STILL_RAD = 0.2 * DEGREE;
/** Time without rotation after which a turn is over, in ms. */
const OVER_AFTER_MS = 500;

/** Finds out when the robot turns and, when it has turned, by how much. */
export function watchTurn(): Watcher {
  let turn: Turn | null = null;
  return (seen) => {
    const { turnedRad: rad, atMs } = seen;
    turn ??= begun(rad, atMs);
    if (Math.abs(rad - turn.lastRad) > STILL_RAD) {
      const isBack = Math.abs(turn.farRad - turn.fromRad) > Math.abs(rad - turn.fromRad) + BACK_RAD;
      if (isBack) turn = begun(turn.farRad, atMs);
      turn.lastRad = rad;
      turn.movedMs = atMs;
      if (Math.abs(rad - turn.fromRad) > Math.abs(turn.farRad - turn.fromRad)) turn.farRad = rad;
    }
    const byRad = rad - turn.fromRad;
    if (atMs - turn.movedMs >= OVER_AFTER_MS) {
      turn = begun(rad, atMs);
      return Math.abs(byRad) < LEAST_RAD ? [] : [news(byRad, Math.round(Math.abs(byRad) / DEGREE))];
    }
    if (turn.isTold || Math.abs(byRad) < LEAST_RAD) return [];
    turn.isTold = true;
    return [news(byRad, null)];

    function news(by: number, degrees: number | null): News {
      return { topic: 'turn', isLeft: by > 0, degrees, seen };
    }
  };
}

interface Turn {
  readonly fromRad: number;
  /** The farthest from there so far. */
  farRad: number;
  lastRad: number;
  movedMs: number;
  isTold: boolean;
}

const begun = (rad: number, atMs: number): Turn => ({
  ...{ fromRad: rad, farRad: rad, lastRad: rad },
  movedMs: atMs,
  isTold: false,
});
