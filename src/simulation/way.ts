import type { Vec } from '#core/geometry';
import type { Chassis } from '#world/chassis';

/** A point that a robot came by, or `null` where the hand lifted it: the next point is where it was set down. */
export type WayPoint = Vec | null;

/** Chosen: points so far apart, in mm, show the narrowest curve (the wheels' own track) within a fifth of a mm. */
const APART_MM = 4;

/** Rounding of positions: a robot that has come farther than its wheels have rolled by more than this was carried. */
const CARRIED_MM = 0.5;

/**
 * Tells the way of the middle of a robot's axle, point by point, beginning with where it stands.
 *
 * @returns to be called after each step of the world
 */
export function createWayTeller(chassis: Chassis, tell: (point: WayPoint) => void): () => void {
  let last: Vec | null = null;
  let lastPathMm = 0;
  return () => {
    const { xMm: x, yMm: y } = chassis.pose();
    if (last !== null) {
      const [dx, dy] = [x - last.x, y - last.y];
      const apartMm = Math.sqrt(dx * dx + dy * dy);
      if (apartMm < APART_MM) return;
      if (apartMm > chassis.pathMm() - lastPathMm + CARRIED_MM) tell(null);
    }
    last = { x, y };
    lastPathMm = chassis.pathMm();
    tell(last);
  };
}
