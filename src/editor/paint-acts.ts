import { isSame } from '#core/same';
import type { SceneEdit } from '#scene/edit';
import { isField } from '#scene/kinds/zone';
import type { PaintColor } from '#scene/paint/paint';
import type { Block, Paper, Scene, SceneObject, Stroke, Wall, Zone } from '#scene/scene';
import { changing } from './edits';
import { freeObjects } from './selection';
import type { Selection } from './tools/tool';

/** An object that may be painted. */
export type Paintable = Stroke | Wall | Block | Zone | Paper;

const isPaintable = (object: SceneObject): object is Paintable =>
  isField(object) || ['stroke', 'wall', 'block', 'fixed-block'].includes(object.type);

/** The selected objects that may be painted, in the order of painting. */
export const selectedPaintable = (scene: Scene, selection: Selection): readonly Paintable[] =>
  freeObjects(scene, selection).filter(isPaintable);

/** True if an object may be without a colour: lines and sheets always have one. */
export const mayBeBare = ({ type }: Paintable): boolean => type !== 'stroke' && type !== 'paper';

/**
 * Gives all selected objects a colour, with the infrared that is usual for it; `null`: takes it from those that may be
 * without. `null` when nothing changes.
 */
export const painted = (scene: Scene, selection: Selection, color: PaintColor | null): SceneEdit | null =>
  changed(scene, selection, (object) => {
    const { infrared: _infrared, ...rest } = object;
    if (color !== null) return { ...rest, color };
    if (!mayBeBare(object)) return object;
    const { color: _color, ...bare } = { color: undefined, ...rest };
    return bare as Paintable;
  });

/** Sets the infrared of all selected objects that have a colour; `null`: as is usual for their colours. */
export const withInfrared = (scene: Scene, selection: Selection, infrared: number | null): SceneEdit | null =>
  changed(scene, selection, (object) => {
    if (object.color === undefined) return object;
    const { infrared: _infrared, ...rest } = object;
    return infrared === null ? rest : { ...rest, infrared };
  });

function changed(scene: Scene, selection: Selection, change: (object: Paintable) => Paintable): SceneEdit | null {
  const objects = selectedPaintable(scene, selection).flatMap((object) => {
    const now = change(object);
    return isSame(now, object) ? [] : [now];
  });
  return objects.length === 0 ? null : changing(objects);
}
