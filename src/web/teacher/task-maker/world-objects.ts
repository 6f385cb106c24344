import type { WorldVariant } from '#check/task/task';
import { isSame } from '#core/same';
import { movedBy, placeOf } from '#editor/kinds/index';
import type { SceneEdit } from '#scene/edit';
import type { Scene } from '#scene/scene';

/** An object that a world has not, or has elsewhere. */
export interface ObjectRow {
  /** Index of its edit. */
  readonly place: number;
  readonly id: string;
  /** The distance by which it is moved, in mm; `null`: it is not there. */
  readonly by: readonly [x: number, y: number] | null;
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
    return id === undefined || more.length > 0 ? null : { id, by: null };
  }
  if (edit.type !== 'replace') return null;
  const [change, ...more] = edit.changes;
  const [made, ...others] = change?.by ?? [];
  const object = scene.objects.find(({ id }) => id === change?.id);
  if (made === undefined || object === undefined || more.length + others.length > 0) return null;
  const [from, to] = [placeOf(object), placeOf(made)];
  const [x, y] = [to[0] - from[0], to[1] - from[1]];
  return isSame(movedBy(object, x, y), made) ? { id: object.id, by: [x, y] } : null;
}

/** The edit of a row; `null`: the course has no such object, so it cannot be moved. */
export function objectEdit(scene: Scene, { id, by }: Pick<ObjectRow, 'id' | 'by'>): SceneEdit | null {
  if (by === null) return { type: 'remove', ids: [id] };
  const object = scene.objects.find((other) => other.id === id);
  return object === undefined ? null : { type: 'replace', changes: [{ id, by: [movedBy(object, by[0], by[1])] }] };
}
