import type { Pose, Vec } from '#core/geometry';

/** State of a robot at one moment, as needed to find the point around which it turns. */
export interface Moment {
  /** Simulated time. */
  readonly timeUs: number;
  /** Pose of the middle of the axle. */
  readonly pose: Pose;
  /** Turned since the start, not wrapped. */
  readonly turnedRad: number;
  /** Length of the path since the start. */
  readonly pathMm: number;
}

/** The point around which a robot turns. */
export interface RotationCentre {
  readonly atMm: Vec;
  /** From there to the middle of the axle. */
  readonly radiusMm: number;
}

/** Simulated time over which the movement is measured, in µs. Chosen: the curve of a moment, without its trembling. */
const WINDOW_US = 60_000;

/**
 * At more than 10 × real time pictures are farther apart than this, in µs: no momentary curve can be derived from them.
 * Chosen: a line follower's curves last about as long.
 */
const LONGEST_US = 200_000;

/** A circle larger than this, in mm, looks like a straight line. Chosen: the longest side of most arenas. */
const WIDEST_MM = 1500;

/** Turning slower than this, in rad/s, does not count. Chosen: 1° in a second. */
const SLOWEST_RAD_PER_S = 0.0175;

/** Rounding of positions: a robot that has moved farther than the length of its path by more than this was carried. */
const CARRIED_MM = 1;

/**
 * The centre of the turn between two moments: the one fixed point of a rigid movement in the plane. For a robot whose
 * wheels do not slip sideways it is on the line of its axle.
 *
 * @returns `null` when the robot drives straight, is at rest, or was carried by the hand, or when the moments are too
 * far apart
 */
export function rotationCentre(before: Moment, now: Moment): RotationCentre | null {
  const angle = now.turnedRad - before.turnedRad;
  const seconds = (now.timeUs - before.timeUs) / 1e6;
  const [dx, dy] = [now.pose.xMm - before.pose.xMm, now.pose.yMm - before.pose.yMm];
  const apartMm = Math.hypot(dx, dy);
  const carried = apartMm > Math.abs(now.pathMm - before.pathMm) + CARRIED_MM;
  const half = Math.sin(angle / 2);
  if (carried || seconds * 1e6 > LONGEST_US || Math.abs(angle) < SLOWEST_RAD_PER_S * seconds || Math.abs(half) < 1e-9)
    return null;
  const radiusMm = Math.abs(apartMm / 2 / half);
  if (radiusMm > WIDEST_MM) return null;
  const toCentre = Math.cos(angle / 2) / half / 2; // left of the path, half a chord away for a quarter turn
  return {
    atMm: {
      x: (before.pose.xMm + now.pose.xMm) / 2 - dy * toCentre,
      y: (before.pose.yMm + now.pose.yMm) / 2 + dx * toCentre,
    },
    radiusMm,
  };
}

/** Follows a run and knows the point around which the robot is turning. */
export interface TurnWatch {
  /** Takes in the newest picture; the same one again changes nothing, `null` (no run) forgets everything. */
  note(moment: Moment | null): void;
  centre(): RotationCentre | null;
}

/** Starts without any history. */
export function createTurnWatch(): TurnWatch {
  let moments: Moment[] = [];
  let found: RotationCentre | null = null;
  return {
    note(moment) {
      if (moment === null) {
        moments = [];
        found = null;
        return;
      }
      const newest = moments.at(-1);
      if (newest?.timeUs === moment.timeUs) return;
      if (newest !== undefined && newest.timeUs > moment.timeUs) moments = [];
      moments.push(moment);
      // The oldest one needed is the last one outside the window.
      while ((moments[1]?.timeUs ?? Infinity) <= moment.timeUs - WINDOW_US) moments.shift();
      const [oldest] = moments;
      found = oldest === undefined || oldest === moment ? null : rotationCentre(oldest, moment);
    },
    centre: () => found,
  };
}
