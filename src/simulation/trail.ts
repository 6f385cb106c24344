import type { Vec } from '#core/geometry';
import type { Chassis } from '#world/chassis';

/** A point of a robot's path, or `null` where the hand tool lifted it: the next point is where it was set down. */
export type TrailPoint = Vec | null;

/** Chosen: points at this distance, in mm, show the narrowest curve (the wheels' own track) within a fifth of a mm. */
const APART_MM = 4;

/** Rounding of positions: a robot that has moved farther than its wheels have rolled by more than this was carried. */
const CARRIED_MM = 0.5;

/**
 * Reports the path of the middle of a robot's axle, point by point, beginning with its start.
 *
 * @returns a function to call after each step of the world
 */
export function createTrailSender(chassis: Chassis, tell: (point: TrailPoint) => void): () => void {
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
