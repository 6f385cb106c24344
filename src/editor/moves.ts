import type { Vec } from '#core/geometry';
import type { SceneObject } from '#scene/scene';

/** The object that another one was made of by moving or copying, and how far that one is from it. */
export interface Moved {
  readonly root: SceneObject;
  readonly by: Vec;
}

const roots = new WeakMap<SceneObject, Moved>();

/** The object that this one was made of by moving or copying, as far as is known; itself if it was not. */
export const rootOf = (object: SceneObject): Moved => roots.get(object) ?? { root: object, by: { x: 0, y: 0 } };

/** Remembers that an object is another one that was moved, or copied to another place. Returns it. */
export function noteMove(from: SceneObject, to: SceneObject, dx: number, dy: number): SceneObject {
  const { root, by } = rootOf(from);
  roots.set(to, { root, by: { x: by.x + dx, y: by.y + dy } });
  return to;
}

/** How far all objects of a list have gone from those of another, if they have gone alike and nothing else has changed. */
export function commonStep(before: readonly SceneObject[], now: readonly SceneObject[]): Vec | null {
  if (before.length !== now.length) return null;
  let step: Vec | null = null;
  for (const [index, object] of now.entries()) {
    const was = before[index];
    if (was === undefined) return null;
    const [one, other] = [rootOf(was), rootOf(object)];
    if (one.root !== other.root) return null;
    const by = { x: other.by.x - one.by.x, y: other.by.y - one.by.y };
    if (step !== null && (step.x !== by.x || step.y !== by.y)) return null;
    step = by;
  }
  return step;
}

/** How far a copy is from its original among some objects; `null`: it is no copy of any. */
export function stepOfCopy(copy: SceneObject, objects: readonly SceneObject[]): Vec | null {
  const { root, by } = rootOf(copy);
  const original = root === copy ? undefined : objects.find((object) => rootOf(object).root === root);
  if (original === undefined) return null;
  const before = rootOf(original).by;
  return { x: by.x - before.x, y: by.y - before.y };
}
