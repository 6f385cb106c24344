import { exactCos, exactSin, exactTan } from '#core/exact-math';
import type { Vec } from '#core/geometry';
import { memo, memoOf } from '#core/memo';
import type { LidarState } from './robot';

/** A ray of the fan that a lidar looks through at eye level: the cell of one column. */
export interface FanRay {
  /** Along the lidar's axis; `null`: nothing in range. */
  readonly depthMm: number | null;
  /** The way along the ray per mm of depth, world frame. */
  readonly perMm: Vec;
}

/** The nearest hit of a fan, world frame. */
export interface FanHit {
  readonly depthMm: number;
  readonly hitMm: Vec;
}

/**
 * Height of the lens. Chosen: with depths along the axis the lowest row of a level lens then sees the floor at 211 mm, as
 * on a robot of franc0r/francor-maqueen-plus-microbit (194 … 216 mm). It is not scaled with the robot, as a large one
 * would look over every block.
 */
export const LENS_HEIGHT_MM = 104;

/** A depth in whole cm, rounded down: so the library of the Plus V3 gives it to the program (mbrobot_plusV3, `getDistanceAt`). */
export const lidarCm = (depthMm: number): number => Math.floor(depthMm / 10);

/** The row at eye level: the lower one of those that look upwards, so that no floor is in it. */
export const eyeLevelRow = (size: LidarState['size']): number => size / 2 - 1;

/** The places of its cells in the lidar's lists, from the left. */
export const eyeLevelCells = memo((size: LidarState['size']): readonly number[] =>
  Array.from({ length: size }, (_, column) => eyeLevelRow(size) * size + column),
);

/** The slopes of the columns against the axis, from the left, by the angle from column to column. */
const slopesOf = memo((columnRad: number): ((size: LidarState['size']) => readonly number[]) =>
  memo((size) => Array.from({ length: size }, (_, column) => exactTan(((size - 1) / 2 - column) * columnRad))),
);

/** The rays at eye level, from the left. */
export const fanOf = memoOf(({ headingRad, openingRad, size, depthMm }: LidarState): readonly FanRay[] => {
  const [cos, sin] = [exactCos(headingRad), exactSin(headingRad)];
  const slopes = slopesOf(openingRad / size)(size);
  return eyeLevelCells(size).map((cell, column) => {
    const slope = slopes[column] ?? 0;
    return { depthMm: depthMm[cell] ?? null, perMm: { x: cos - slope * sin, y: sin + slope * cos } };
  });
});

/** The place at this depth on a ray of a lidar. */
export const alongRay = ({ fromMm }: LidarState, { perMm }: FanRay, depthMm: number): Vec => ({
  x: fromMm.x + depthMm * perMm.x,
  y: fromMm.y + depthMm * perMm.y,
});

/** The nearest thing that a lidar sees at eye level; `null`: nothing in range. */
export function nearestOfFan(lidar: LidarState): FanHit | null {
  let best: FanHit | null = null;
  for (const ray of fanOf(lidar)) {
    const { depthMm } = ray;
    if (depthMm !== null && depthMm < (best?.depthMm ?? Infinity))
      best = { depthMm, hitMm: alongRay(lidar, ray, depthMm) };
  }
  return best;
}
