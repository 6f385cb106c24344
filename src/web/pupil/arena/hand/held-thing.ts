import type { Pose, Vec } from '#core/geometry';
import { normalAngle } from './hand-gesture';

/** A thing that the hand can hold. */
export type HeldThing = { readonly kind: 'robot' } | { readonly kind: 'block'; readonly id: string };

/** Place of a thing's origin. */
export function toVec(pose: Pose): Vec {
  return { x: pose.xMm, y: pose.yMm };
}

/** True if both are the same thing. */
export function isSameThing(a: HeldThing, b: HeldThing): boolean {
  return a.kind === 'robot' ? b.kind === 'robot' : b.kind === 'block' && a.id === b.id;
}

/** True if two poses differ by less than can be seen: 0.3 mm and 0.3°. */
export function isNear(a: Pose, b: Pose): boolean {
  const apart = Math.hypot(a.xMm - b.xMm, a.yMm - b.yMm);
  return apart < 0.3 && Math.abs(normalAngle(a.headingRad - b.headingRad)) < 0.005;
}
