import type { Pose, Vec } from '#core/geometry';
import type { Snapshot } from '#simulation/snapshot';
import type { Verdict } from '#simulation/task/verdict';

/** Everything to announce about a run at one moment, without what changes with every picture. */
export interface Moment {
  /** By the clock on the wall, in ms: what is told must be followed by a person, at any speed of the run. */
  readonly atMs: number;
  readonly pose: Pose;
  /** Rotation and path since the start. */
  readonly turnedRad: number;
  readonly pathMm: number;
  /** The distance sensor's hit; `null`: nothing in range, `undefined`: the robot has no such sensor. */
  readonly ahead: { readonly mm: number; readonly hitMm: Vec | null } | null | undefined;
  /** From left to right. */
  readonly lineSensors: readonly { readonly name: string; readonly isDark: boolean }[];
  /** Number of touches of the robot since the start. */
  readonly touches: number;
  readonly verdict: Verdict | null;
  /** Poses of blocks and moving obstacles, by their id. */
  readonly moved: Readonly<Record<string, Pose>>;
}

/** The moment in a picture of the run; `null` without a robot. */
export function momentOf(snapshot: Snapshot, atMs: number): Moment | null {
  const { robot, verdict, blocks, movers } = snapshot;
  if (robot === null) return null;
  const { ultrasonic, lineSensors } = robot.state;
  return {
    atMs,
    pose: robot.pose,
    turnedRad: robot.turnedRad,
    pathMm: robot.pathMm,
    ahead: ultrasonic === null ? undefined : aheadOf(ultrasonic),
    lineSensors: [...lineSensors]
      .sort((one, other) => other.atMm.y - one.atMm.y)
      .map(({ name, bright }) => ({ name, isDark: !bright })),
    touches: robot.collisions,
    verdict,
    moved: Object.keys(movers).length === 0 ? blocks : { ...blocks, ...movers },
  };
}

const aheadOf = ({ distanceMm: mm, hitMm }: { distanceMm: number | null; hitMm: Vec | null }): Moment['ahead'] =>
  mm === null ? null : { mm, hitMm };
