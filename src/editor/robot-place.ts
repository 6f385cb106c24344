import { boundsOfOutline, type Outline } from '#scene/outline';
import { robotOutlines } from '#scene/placement';
import type { Point, RobotStart } from '#scene/scene';
import { boundsAll } from './bounds';
import { toPoint, toVec } from './plane';
import { intoArena } from './snap';

/**
 * The place nearest to the robot's that has all of its body inside the arena, in whole mm; in an arena that is too small
 * for it, the place where it sticks out as little as can be.
 *
 * @param footprint convex parts of the robot at scale 1 in its own frame; empty: only its origin is kept inside
 */
export function placeInside(robot: RobotStart, arena: Point, footprint: readonly Outline[]): Point {
  const body = boundsAll(robotOutlines({ ...robot, at: [0, 0] }, footprint).map(boundsOfOutline));
  if (!body) return toPoint(intoArena(toVec(robot.at), arena));
  return [
    coordinateInside(robot.at[0], body.minX, body.maxX, arena[0]),
    coordinateInside(robot.at[1], body.minY, body.maxY, arena[1]),
  ];
}

function coordinateInside(at: number, min: number, max: number, length: number): number {
  const least = Math.ceil(-min - ROUNDING_MM);
  const most = Math.floor(length - max + ROUNDING_MM);
  if (least > most) return Math.round((length - max - min) / 2) + 0;
  return Math.min(most, Math.max(least, Math.round(at))) + 0;
}

/** Rounding errors of a rotation are smaller than this. */
const ROUNDING_MM = 1e-6;
