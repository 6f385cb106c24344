import type { Vec } from '#core/geometry';
import type { Switched } from '#picture/kinds/lamp';
import type { Barrier, Lamp, Scene, SceneObject } from '#scene/scene';

/** True if a lamp or a barrier is switched by hand. */
export const isByHand = (object: SceneObject): object is Lamp | Barrier =>
  (object.type === 'lamp' && object.on === 'hand') || (object.type === 'barrier' && object.opens === 'hand');

/** The place of a lamp, the middle of a barrier; world mm. */
export function middleOf(object: Lamp | Barrier): Vec {
  if (object.type === 'lamp') return { x: object.at[0], y: object.at[1] };
  const { from, to } = object;
  return { x: (from[0] + to[0]) / 2, y: (from[1] + to[1]) / 2 };
}

/**
 * Makes a function that shows the lamps and barriers of a course as a run has them, by object id. It gives the same
 * course again as long as nothing was switched: a run has a new state with each picture.
 */
export function createSwitchedScene(): (scene: Scene, states: Readonly<Record<string, boolean>> | undefined) => Scene {
  let before: { readonly scene: Scene; readonly key: string; readonly shown: Scene } | null = null;
  return (scene, states) => {
    if (states === undefined) return scene;
    const key = JSON.stringify(states);
    if (before?.scene === scene && before.key === key) return before.shown;
    const objects = scene.objects.map((object): SceneObject & Switched => {
      const isOn = states[object.id];
      return isOn === undefined ? object : { ...object, isOn };
    });
    before = { scene, key, shown: { ...scene, objects } };
    return before.shown;
  };
}
