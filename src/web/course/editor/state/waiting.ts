import type { Scene } from '#scene/scene';
import { pendingChanges } from '#simulation/at-once';

/** True if part of a course takes effect only at the next start of a run that began with `start`. */
export function waitsForStart(start: Scene, now: Scene): boolean {
  if (start === now) return false;
  const { coming, going, robot, arena } = pendingChanges(start, now);
  return coming.length > 0 || going.length > 0 || robot || arena;
}
