import type { Pose } from '#core/geometry';

/** Less than any robot drives or turns between two looks. */
const [STILL_MM, STILL_RAD] = [0.1, 0.001];

/** True if a robot is where it was; without a robot, too. */
export function isStill(now: Pose | null, before: Pose | null): boolean {
  if (now === null || before === null) return now === before;
  const [x, y, turned] = [now.xMm - before.xMm, now.yMm - before.yMm, now.headingRad - before.headingRad];
  return Math.abs(x) < STILL_MM && Math.abs(y) < STILL_MM && Math.abs(turned) < STILL_RAD;
}
