import type { SceneEdit } from '#scene/edit';
import { isStanding, withHeight } from '#scene/kinds/heights';
import type { Point, Scene, SceneObject } from '#scene/scene';
import { isSame } from '#core/same';
import { changing } from '../edits';
import { isLargeEnough } from '../kinds/box';
import { kindOf } from '../kinds/index';
import { distanceMm, toVec } from '../plane';
import { freeObjects } from '../selection';
import type { Selection } from '../tools/tool';

/**
 * Gives what is selected the size of the first one that was chosen: boxes its extent, walls its length and thickness,
 * words its height. What stands gets its height, too, or as it the usual one. `null` when nothing of its sort is selected
 * with it, or all have that size.
 */
export function sizedAlike(scene: Scene, selection: Selection): SceneEdit | null {
  const objects = freeObjects(scene, selection);
  const model = objects.find(({ id }) => id === selection.ids[0]);
  if (!model) return null;
  return changing(
    objects.flatMap((object) => {
      const changed = alike(object, model);
      return changed === null || isSame(changed, object) ? [] : [changed];
    }),
  );
}

function alike(object: SceneObject, model: SceneObject): SceneObject | null {
  if ('size' in object && 'size' in model) {
    const sized = { ...object, size: model.size };
    return isLargeEnough(sized) ? asHigh(sized, model) : null;
  }
  if (object.type === 'label' && model.type === 'label') return { ...object, height: model.height };
  if (object.type !== 'wall' || model.type !== 'wall') return null;
  const factor = lengthMm(model) / lengthMm(object);
  const long = kindOf(object).scaled(object, kindOf(object).middle(object), { x: factor, y: factor });
  return long?.type === 'wall' ? asHigh({ ...long, thickness: model.thickness }, model) : null;
}

const asHigh = (object: SceneObject, model: SceneObject): SceneObject =>
  isStanding(object) && isStanding(model) ? withHeight(object, model.height ?? null) : object;

const lengthMm = ({ from, to }: { readonly from: Point; readonly to: Point }): number =>
  distanceMm(toVec(from), toVec(to));
