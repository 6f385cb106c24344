import type { Pose, Vec } from '#core/geometry';
import { nearestOfFan } from '#robots/lidar-fan';
import type { ColourState, RobotState } from '#robots/robot';
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
  /** The hit of the distance sensor, else the nearest of a lidar; `null`: nothing in range, `undefined`: the robot has neither. */
  readonly ahead: { readonly mm: number; readonly hitMm: Vec | null } | null | undefined;
  /** From left to right. */
  readonly lineSensors: readonly { readonly name: string; readonly isDark: boolean }[];
  /** The names of what its colour sensors see. */
  readonly colours: readonly Pick<ColourState, 'side' | 'name'>[];
  /** The last answer of its camera; `null`: the program has not asked lately, or there is none. */
  readonly inPicture: readonly { readonly isLine: boolean; readonly id: number }[] | null;
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
  const { lineSensors, colours = [], camera } = robot.state;
  return {
    atMs,
    pose: robot.pose,
    turnedRad: robot.turnedRad,
    pathMm: robot.pathMm,
    ahead: aheadOf(robot.state),
    lineSensors: [...lineSensors]
      .sort((one, other) => other.atMm.y - one.atMm.y)
      .map(({ name, bright }) => ({ name, isDark: !bright })),
    colours: colours.map(({ side, name }) => ({ side, name })),
    inPicture: camera?.seen?.map(({ kind, id }) => ({ isLine: kind === 'arrow', id })) ?? null,
    touches: robot.collisions,
    verdict,
    moved: Object.keys(movers).length === 0 ? blocks : { ...blocks, ...movers },
  };
}

function aheadOf({ ultrasonic, lidar }: Pick<RobotState, 'ultrasonic' | 'lidar'>): Moment['ahead'] {
  if (ultrasonic !== null) return ultrasonic.distanceMm === null ? null : { mm: ultrasonic.distanceMm, hitMm: ultrasonic.hitMm }; // prettier-ignore
  if (lidar === null) return undefined;
  const nearest = nearestOfFan(lidar);
  return nearest && { mm: nearest.depthMm, hitMm: nearest.hitMm };
}
