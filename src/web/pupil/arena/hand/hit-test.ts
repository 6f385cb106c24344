import type { Pose, Vec } from '#core/geometry';
import type { PlacedBlock } from '../model/arena-model';

/** The thing under a pointer. */
export type Target =
  | { readonly kind: 'ring' }
  | { readonly kind: 'robot' }
  | { readonly kind: 'block'; readonly id: string }
  | { readonly kind: 'floor' };

/** The robot as hit-testing sees it. */
export interface RobotShape {
  readonly pose: Pose;
  /** Convex parts in the robot's frame, mm, counter-clockwise. */
  readonly outlineMm: readonly (readonly Vec[])[];
  readonly scale: number;
  /** Distance from the origin to the front end of its attachments, in mm of the real robot; left out: it has none. */
  readonly frontMm?: number;
}

/** The things that can be pointed at. */
export interface Things {
  readonly robot: RobotShape | null;
  /** The knob of the ring in world mm, when the ring shows. */
  readonly knobMm: Vec | null;
  readonly blocks: readonly PlacedBlock[];
}

/** Distances that count as a hit, in mm: beside a thing, and around the knob or the middle of a small thing. */
export interface Reach {
  readonly slopMm: number;
  readonly touchMm: number;
}

/** The topmost thing at a place: ring, robot, then blocks, the last drawn first. */
export function targetAt(pointMm: Vec, things: Things, reach: Reach): Target {
  if (things.knobMm !== null && distance(pointMm, things.knobMm) <= reach.touchMm) return { kind: 'ring' };
  const { robot } = things;
  if (robot !== null && isOnRobot(pointMm, robot, reach)) return { kind: 'robot' };
  for (let i = things.blocks.length - 1; i >= 0; i -= 1) {
    const block = things.blocks[i];
    if (block !== undefined && isOnBlock(pointMm, block, reach)) return { kind: 'block', id: block.id };
  }
  return { kind: 'floor' };
}

/** Distance from the robot's origin to the farthest corner of its outline, in mm. */
export function robotRadiusMm(robot: Pick<RobotShape, 'outlineMm' | 'scale'>): number {
  let radius = 0;
  for (const part of robot.outlineMm)
    for (const corner of part) radius = Math.max(radius, Math.hypot(corner.x, corner.y));
  return radius * robot.scale;
}

/** Converts a place to a thing's own frame. */
export function toLocal(pose: Pose, pointMm: Vec): Vec {
  const dx = pointMm.x - pose.xMm;
  const dy = pointMm.y - pose.yMm;
  const cos = Math.cos(pose.headingRad);
  const sin = Math.sin(pose.headingRad);
  return { x: dx * cos + dy * sin, y: dy * cos - dx * sin };
}

function isOnRobot(pointMm: Vec, robot: RobotShape, reach: Reach): boolean {
  const local = toLocal(robot.pose, pointMm);
  const unscaled = { x: local.x / robot.scale, y: local.y / robot.scale };
  if (Math.hypot(local.x, local.y) <= reach.touchMm) return true;
  return robot.outlineMm.some((part) => isInConvex(unscaled, part, reach.slopMm / robot.scale));
}

function isOnBlock(pointMm: Vec, block: PlacedBlock, reach: Reach): boolean {
  const local = toLocal(block.pose, pointMm);
  const halfX = Math.max(block.sizeMm.x / 2 + reach.slopMm, reach.touchMm);
  const halfY = Math.max(block.sizeMm.y / 2 + reach.slopMm, reach.touchMm);
  return Math.abs(local.x) <= halfX && Math.abs(local.y) <= halfY;
}

/** True if a point lies in a convex polygon (counter-clockwise), or within `slop` of each edge's line. */
function isInConvex(point: Vec, polygon: readonly Vec[], slop: number): boolean {
  return polygon.every((from, i) => {
    const to = polygon[(i + 1) % polygon.length] ?? from;
    const edge = { x: to.x - from.x, y: to.y - from.y };
    const inward = edge.x * (point.y - from.y) - edge.y * (point.x - from.x);
    return inward >= -slop * Math.hypot(edge.x, edge.y);
  });
}

function distance(a: Vec, b: Vec): number {
  return Math.hypot(a.x - b.x, a.y - b.y);
}
