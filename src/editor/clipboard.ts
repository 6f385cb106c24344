import type { SceneEdit } from '#scene/edit';
import { boundsOf } from '#scene/kinds/index';
import type { Scene, SceneObject } from '#scene/scene';
import { stepInside } from './arrange';
import { boundsAll } from './bounds';
import { freeIds } from './ids';
import { movedBy } from './kinds/index';
import { nextCheckpoint } from './kinds/zone';
import { selectedObjects } from './selection';
import type { Selection } from './tools/tool';

/** Copied objects: plain data that can be pasted into any course. */
export interface Clip {
  readonly objects: readonly SceneObject[];
}

/** Objects put into a course, and the selection of just these. */
export interface Pasted {
  readonly edit: SceneEdit;
  readonly selection: Selection;
}

/** Distance of a copy from its original, in mm. Chosen: two lines of the grid, so that both can be seen and grabbed. */
const COPY_OFFSET_MM = 20;

/** The selected objects as a clip; `null` when none is. The robot's start is not copied: there is only one. */
export function copied(scene: Scene, selection: Selection): Clip | null {
  const objects = selectedObjects(scene, selection);
  return objects.length === 0 ? null : { objects };
}

/**
 * Pastes copied objects into a course: to the right of and below their originals, with ids of its own and checkpoints
 * with the next numbers.
 *
 * @param time how often the same has been pasted, this time included; each copy lies further away
 * @returns an edit that a full course refuses; `null` if there is nothing to paste, or no number left for a checkpoint
 */
export function pasted(scene: Scene, clip: Clip, time = 1): Pasted | null {
  const around = boundsAll(clip.objects.map(boundsOf));
  if (!around) return null;
  const offsetMm = time * COPY_OFFSET_MM;
  const [dx, dy] = stepInside(around, { x: offsetMm, y: -offsetMm }, scene.size);
  const freeId = freeIds(scene);
  const numbers: number[] = [];
  const objects: SceneObject[] = [];
  for (const object of clip.objects) {
    const copy: SceneObject = { ...movedBy(object, dx, dy), id: freeId(object.type) };
    if (copy.type !== 'checkpoint') {
      objects.push(copy);
      continue;
    }
    const number = nextCheckpoint(scene, numbers);
    if (number === null) return null;
    numbers.push(number);
    objects.push({ ...copy, number });
  }
  return { edit: { type: 'add', objects }, selection: { ids: objects.map(({ id }) => id), robot: false } };
}

/** Copies what is selected and pastes it in one step. */
export function duplicated(scene: Scene, selection: Selection): Pasted | null {
  const clip = copied(scene, selection);
  return clip && pasted(scene, clip);
}
