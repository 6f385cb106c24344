import type { Vec } from '#core/geometry';
import type { Switched } from '#picture/kinds/lamp';
import { carriedTags } from '#scene/kinds/stuck-tags';
import type { Barrier, Lamp, Scene, SceneObject } from '#scene/scene';
import type { Snapshot } from '#simulation/snapshot';

/** True if a lamp or a barrier is switched by hand. */
export const isByHand = (object: SceneObject): object is Lamp | Barrier =>
  (object.type === 'lamp' && object.on === 'hand') || (object.type === 'barrier' && object.opens === 'hand');

/** The place of a lamp, the middle of a barrier; world mm. */
export function middleOf(object: Lamp | Barrier): Vec {
  if (object.type === 'lamp') return { x: object.at[0], y: object.at[1] };
  const { from, to } = object;
  return { x: (from[0] + to[0]) / 2, y: (from[1] + to[1]) / 2 };
}

/** The part of a run that changes its still picture: lamps and barriers that were switched. */
export type StillState = Partial<Pick<Snapshot, 'switched'>>;

/**
 * Makes a function that shows the lamps and barriers of a course as a run has them, without the tags on what moves, which
 * are drawn with that. It gives the same course again as long as none of them has changed: a run has a new state with each
 * picture.
 */
export function createStillScene(): (scene: Scene, state: StillState | null) => Scene {
  let before: { readonly scene: Scene; readonly key: string; readonly shown: Scene } | null = null;
  return (scene, state) => {
    const carried = carriedTags(scene.objects);
    const { switched = {} } = state ?? {};
    const key = JSON.stringify(switched);
    if (key === '{}' && carried.length === 0) return scene;
    if (before?.scene === scene && before.key === key) return before.shown;
    const going = new Set(carried.map(({ tag }) => tag.id));
    const standing = scene.objects.filter(({ id }) => !going.has(id));
    const objects = standing.map((object): SceneObject & Switched => {
      const isOn = switched[object.id];
      return isOn === undefined ? object : { ...object, isOn };
    });
    before = { scene, key, shown: { ...scene, objects } };
    return before.shown;
  };
}
