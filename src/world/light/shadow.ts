import { exactCos, exactSin } from '#core/exact-math';
import type { Vec } from '#core/geometry';
import type { Obstacle } from '../probes/distance-cone';

/** A straight way of light, from a lamp down to an eye. */
export interface Ray {
  readonly fromMm: Vec;
  readonly toMm: Vec;
  /** Height above the floor at its two ends, in mm; it falls or is level. */
  readonly fromHeightMm: number;
  readonly toHeightMm: number;
}

/** True if a ray meets an obstacle: where it leaves the obstacle's outline, on the eye's side, it is lower than its top. */
export function isInShadow(ray: Ray, obstacle: Obstacle): boolean {
  const { fromHeightMm, toHeightMm } = ray;
  const leaves = whereItLeaves(ray, obstacle);
  return leaves !== null && fromHeightMm + (toHeightMm - fromHeightMm) * leaves < obstacle.heightMm;
}

/** The share of a ray, from 0 at the lamp to 1 at the eye, at which it leaves an obstacle's outline; `null`: it passes it by. */
function whereItLeaves({ fromMm, toMm }: Ray, obstacle: Obstacle): number | null {
  const { cornersMm, radiusMm } = obstacle;
  const { xMm, yMm, headingRad } = obstacle.pose();
  const x = fromMm.x - xMm;
  const y = fromMm.y - yMm;
  const dx = toMm.x - fromMm.x;
  const dy = toMm.y - fromMm.y;
  const round = withinCircle(x, y, dx, dy, radiusMm);
  if (round === null || cornersMm.length === 0) return round;
  if (headingRad === 0) return withinCorners({ x, y }, { x: dx, y: dy }, cornersMm);
  const [cos, sin] = [exactCos(headingRad), exactSin(headingRad)];
  const own = (vx: number, vy: number): Vec => ({ x: vx * cos + vy * sin, y: vy * cos - vx * sin });
  return withinCorners(own(x, y), own(dx, dy), cornersMm);
}

/** The same for the way from (x, y) along (dx, dy) and a circle around the origin. */
function withinCircle(x: number, y: number, dx: number, dy: number, radius: number): number | null {
  const a = dx * dx + dy * dy;
  const c = x * x + y * y - radius * radius;
  if (a === 0) return c < 0 ? 1 : null;
  const b = x * dx + y * dy;
  const root = b * b - a * c;
  if (root <= 0) return null;
  const half = Math.sqrt(root);
  const enters = Math.max(0, (-b - half) / a);
  const leaves = Math.min(1, (-b + half) / a);
  return enters < leaves ? leaves : null;
}

/** The same for a convex outline, counter-clockwise. */
function withinCorners(from: Vec, way: Vec, corners: readonly Vec[]): number | null {
  let enters = 0;
  let leaves = 1;
  let a = corners[corners.length - 1] ?? from;
  for (const b of corners) {
    // How far outside this edge the way begins, and how much farther out it leads.
    const outside = (from.x - a.x) * (b.y - a.y) - (from.y - a.y) * (b.x - a.x);
    const outwards = way.x * (b.y - a.y) - way.y * (b.x - a.x);
    if (outwards < 0) enters = Math.max(enters, -outside / outwards);
    else if (outwards > 0) leaves = Math.min(leaves, -outside / outwards);
    else if (outside > 0) return null;
    if (enters >= leaves) return null;
    a = b;
  }
  return leaves;
}
