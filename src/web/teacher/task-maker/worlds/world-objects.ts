import { taskLimits, type WorldVariant } from '#check/task/task';
import { isSame } from '#core/same';
import { placeOf } from '#editor/kinds/index';
import type { SceneEdit } from '#scene/edit';
import type { Point, Scene, SceneObject } from '#scene/scene';

/** An object that a world has not, or has elsewhere. */
export interface ObjectRow {
  /** Index of its edit. */
  readonly place: number;
  readonly id: string;
  /** The object as the world has it; `null`: it is not there. */
  readonly made: SceneObject | null;
  /** The distance from its place in the course, in mm; `null`: it is not there. */
  readonly by: Point | null;
}

/** The edits of a world that the page can show; others come from a file, and are kept. */
export const objectRows = (scene: Scene, { edits }: WorldVariant): readonly ObjectRow[] =>
  edits.flatMap((edit, place) => {
    const row = rowOf(scene, edit);
    return row === null ? [] : [{ place, ...row }];
  });

function rowOf(scene: Scene, edit: SceneEdit): Omit<ObjectRow, 'place'> | null {
  if (edit.type === 'remove') {
    const [id, ...more] = edit.ids;
    return id === undefined || more.length > 0 ? null : { id, made: null, by: null };
  }
  if (edit.type !== 'replace') return null;
  const [change, ...more] = edit.changes;
  const [made, ...others] = change?.by ?? [];
  const object = scene.objects.find(({ id }) => id === change?.id);
  if (made?.id !== object?.id || made === undefined || object === undefined) return null;
  if (made.type !== object.type || more.length + others.length > 0) return null;
  const [from, to] = [placeOf(object), placeOf(made)];
  return { id: object.id, made, by: [to[0] - from[0], to[1] - from[1]] };
}

/** The edit that leaves an object out (`null`), or puts it down as it is made. */
export const objectEdit = (id: string, made: SceneObject | null): SceneEdit =>
  made === null ? { type: 'remove', ids: [id] } : { type: 'replace', changes: [{ id, by: [made] }] };

/**
 * The edits of a world with an object left out (`null`) or changed, in the place of the edit that it had; without one if it
 * is again as the course has it, or if the world has all the edits that a task may hold.
 */
export function withObject(
  scene: Scene,
  world: WorldVariant,
  id: string,
  made: SceneObject | null,
): WorldVariant['edits'] {
  const before = objectRows(scene, world).find((row) => row.id === id);
  const isAsCourse = isSame(
    scene.objects.find((object) => object.id === id),
    made,
  );
  if (before === undefined) {
    const isFull = world.edits.length >= taskLimits.edits;
    return isAsCourse || isFull ? world.edits : [...world.edits, objectEdit(id, made)];
  }
  return world.edits.toSpliced(before.place, 1, ...(isAsCourse ? [] : [objectEdit(id, made)]));
}
