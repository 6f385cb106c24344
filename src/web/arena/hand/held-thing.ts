import type { Pose, Vec } from '#core/geometry';
import { normalAngle } from './hand-gesture';

/** What can be in the hand. */
export type HeldThing = { readonly kind: 'robot' } | { readonly kind: 'block'; readonly id: string };

/** Where a thing's origin is. */
export function toVec(pose: Pose): Vec {
  return { x: pose.xMm, y: pose.yMm };
}

/** Whether both are the same thing. */
export function isSameThing(a: HeldThing, b: HeldThing): boolean {
  return a.kind === 'robot' ? b.kind === 'robot' : b.kind === 'block' && a.id === b.id;
}

/** Whether two poses differ by less than can be seen: 0.3 mm and 0.3°. */
export function isNear(a: Pose, b: Pose): boolean {
  const apart = Math.hypot(a.xMm - b.xMm, a.yMm - b.yMm);
  return apart < 0.3 && Math.abs(normalAngle(a.headingRad - b.headingRad)) < 0.005;
}
