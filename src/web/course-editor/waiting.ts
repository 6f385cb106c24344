import type { Scene, SceneObject } from '#scene/scene';

import { waitsForStart as isBuiltIn } from '../canvas/live-scene';

/**
 * Whether a run that began with one course knows all that matters to it of another. Lines, background, fields, words,
 * the task and blocks that can be pushed get into a run at once; whatever is built in when it starts waits for the next
 * start: walls, fixed blocks, spikes, movers, the robot and the size of the arena.
 */
export const waitsForStart = (start: Scene, now: Scene): boolean => differs(start, now, isBuiltIn);

/** Whether anything solid stands elsewhere in the second course: what a picture of an earlier run would show wrongly. */
export const movesBodies = (before: Scene, after: Scene): boolean =>
  differs(before, after, (object) => isBuiltIn(object) || object.type === 'block');

function differs(start: Scene, now: Scene, counts: (object: SceneObject) => boolean): boolean {
  if (start === now) return false;
  if (start.size[0] !== now.size[0] || start.size[1] !== now.size[1]) return true;
  if (!isSame(start.robot, now.robot)) return true;
  if (start.objects === now.objects) return false;
  const before = new Map(start.objects.filter(counts).map((object) => [object.id, object]));
  const after = now.objects.filter(counts);
  return after.length !== before.size || after.some((object) => !isSame(before.get(object.id), object));
}

const isSame = (one: unknown, other: unknown): boolean =>
  one === other || JSON.stringify(one) === JSON.stringify(other);
