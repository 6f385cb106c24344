import type { SceneEdit } from '#scene/edit';
import { boundsOf } from '#scene/kinds/index';
import { boundsMeet } from '#scene/outline';
import type { Scene, SceneObject } from '#scene/scene';
import { kindOf } from '../kinds/index';
import { freeObjects } from '../selection';
import type { Selection } from '../tools/tool';

/** A move in the painting order: over or under the next thing that it touches, or over or under all. */
export type Order = 'front' | 'forward' | 'backward' | 'back';

/**
 * Moves what is selected in the order of painting; among themselves the things keep theirs. What lies in another layer
 * (zones, lines, words, things) stays over or under it anyway, so only those of its own layer count.
 *
 * @returns `null` when that changes nothing that can be seen
 */
export function reordered(scene: Scene, selection: Selection, order: Order): SceneEdit | null {
  const chosen = new Set(freeObjects(scene, selection).map(({ id }) => id));
  const isUp = order === 'front' || order === 'forward';
  const isFar = order === 'front' || order === 'back';
  // Seen from the side to which the things go: each passes what lies between it and its new neighbour.
  const all = isUp ? [...scene.objects] : [...scene.objects].reverse();
  const moved = new Set<SceneObject>();
  for (const object of [...all].reverse()) {
    if (!chosen.has(object.id)) continue;
    const at = all.indexOf(object);
    const to = newPlace(all, at, chosen, isFar);
    if (to === at) continue;
    all.splice(at, 1);
    all.splice(to, 0, object);
    moved.add(object);
  }
  if (moved.size === 0) return null;
  if (!isUp) all.reverse();
  const objects = all.filter((object) => moved.has(object));
  return {
    type: 'all',
    edits: [
      { type: 'remove', ids: objects.map(({ id }) => id) },
      { type: 'add', objects, at: objects.map((object) => all.indexOf(object)) },
    ],
  };
}

/** The place right above the thing that is to be passed; its own place when there is none. */
function newPlace(all: readonly SceneObject[], at: number, chosen: ReadonlySet<string>, isFar: boolean): number {
  const object = all[at];
  if (!object) return at;
  const { layer } = kindOf(object);
  const around = boundsOf(object);
  const isPassed = (other: SceneObject, index: number): boolean =>
    index > at &&
    !chosen.has(other.id) &&
    kindOf(other).layer === layer &&
    (isFar || boundsMeet(boundsOf(other), around));
  const passed = isFar ? all.findLastIndex(isPassed) : all.findIndex(isPassed);
  return passed === -1 ? at : passed;
}
