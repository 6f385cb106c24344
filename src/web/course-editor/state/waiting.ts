import { isSame } from '#core/same';
import type { Scene } from '#scene/scene';
import { pendingChanges } from '#simulation/at-once';

/** Whether anything of a course waits for the next start of a run that began with `start`. */
export function waitsForStart(start: Scene, now: Scene): boolean {
  if (start === now) return false;
  const { coming, going, robot, arena } = pendingChanges(start, now);
  return coming.length > 0 || going.length > 0 || robot || arena;
}

/** Whether anything solid stands elsewhere in the second course: what a picture of an earlier run would show wrongly. */
export const movesBodies = (before: Scene, after: Scene): boolean =>
  waitsForStart(before, after) || !isSame(blocksOf(before), blocksOf(after));

const blocksOf = ({ objects }: Scene): Scene['objects'] => objects.filter(({ type }) => type === 'block');
