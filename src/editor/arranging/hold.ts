import type { SceneEdit } from '#scene/edit';
import { isSame } from '#core/same';
import type { Scene, SceneObject } from '#scene/scene';
import { changing } from '../edits';
import { freeGroups } from '../ids';
import { freeObjects, selectedObjects } from '../selection';
import type { Selection } from '../tools/tool';

/** Locks what is selected: nothing but unlocking changes it then. `null`: all of it is locked, or nothing is selected. */
export const locked = (scene: Scene, selection: Selection): SceneEdit | null =>
  changing(freeObjects(scene, selection).map((object) => ({ ...object, lock: true })));

/** Unlocks what is selected; `null`: nothing of it is locked. */
export const unlocked = (scene: Scene, selection: Selection): SceneEdit | null =>
  changing(
    selectedObjects(scene, selection)
      .filter(({ lock }) => lock)
      .map(withoutLock),
  );

/** An object without its lock; the same object if it is not locked. */
export function withoutLock(object: SceneObject): SceneObject {
  const { lock, ...rest } = object;
  return lock === undefined ? object : rest;
}

/** Makes all that is selected one new group; it leaves its old groups. `null`: it is one already, or fewer than two. */
export function grouped(scene: Scene, selection: Selection): SceneEdit | null {
  const objects = freeObjects(scene, selection);
  const [first] = objects;
  if (!first || objects.length < 2) return null;
  const chosen = new Set(objects);
  const isGroup =
    first.group !== undefined &&
    objects.every(({ group }) => group === first.group) &&
    scene.objects.every((object) => object.group !== first.group || chosen.has(object));
  const group = freeGroups(scene)();
  return isGroup ? null : changing(objects.map((object) => ({ ...object, group })));
}

/** Dissolves every group of which something is selected, but for its locked members; `null`: nothing is in one. */
export function ungrouped(scene: Scene, selection: Selection): SceneEdit | null {
  const names = new Set(freeObjects(scene, selection).map(({ group }) => group));
  return changing(
    scene.objects
      .filter(({ group, lock }) => group !== undefined && names.has(group) && lock === undefined)
      .map(withoutGroup),
  );
}

function withoutGroup(object: SceneObject): SceneObject {
  const { group, ...rest } = object;
  return group === undefined ? object : rest;
}

/** True if two states of an object differ in nothing but its lock and its group. */
export const isHeldAlike = (one: SceneObject, other: SceneObject): boolean =>
  isSame(withoutGroup(withoutLock(one)), withoutGroup(withoutLock(other)));
