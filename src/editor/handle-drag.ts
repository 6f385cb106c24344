import { wrappedDeg } from '#core/angle';
import type { SceneEdit } from '#scene/edit';
import type { Scene } from '#scene/scene';
import { middleOfSelection, turnedBy } from './arrange';
import { endOf, startOf } from './drag';
import { changing } from './edits';
import { kindOf } from './kinds/index';
import { directionDeg, distanceMm, minus, plus, steppedDeg } from './plane';
import { lured } from './snap/attract';
import type { Drag, Handle, Selection, ToolContext, Turn } from './tools/tool';

/** The result of a drag of a handle. */
export function handleDragged(handle: Handle, drag: Drag, context: ToolContext): SceneEdit | null {
  const { scene, selection, footprint } = context;
  if (handle.kind === 'rotate') {
    const angleDeg = draggedAngle(drag, scene, selection);
    return angleDeg === null ? null : turnedBy(scene, selection, angleDeg, footprint);
  }
  const object = scene.objects.find(({ id }) => id === handle.id);
  if (!object) return null;
  // A thing that is grabbed beside its middle keeps that distance.
  const place = plus(handle.at, minus(endOf(drag), startOf(drag)));
  const snapping = lured(drag, context, selection);
  const kind = kindOf(object);
  const changed =
    handle.kind === 'size'
      ? kind.sized?.(object, place, snapping)
      : kind.endMoved?.(object, handle.kind, place, snapping, scene);
  return changed ? changing([changed]) : null;
}

/** Steps of a drag that turns, in degrees. Chosen: both halves of a right angle and its thirds; a degree when free. */
const STEP_DEG = 15;
const FREE_STEP_DEG = 1;

/**
 * By how much a drag turns a selection about its middle. `null` when there is nothing to turn or the drag has not left the
 * middle.
 */
export function draggedAngle(drag: Drag, scene: Scene, selection: Selection): number | null {
  const pivot = middleOfSelection(scene, selection);
  const start = pivot && drag.path.find((place) => distanceMm(pivot, place) > drag.reachMm / 2);
  const end = endOf(drag);
  if (!pivot || !start || distanceMm(pivot, end) === 0) return null;
  const angleDeg = wrappedDeg(directionDeg(pivot, end) - directionDeg(pivot, start));
  return steppedDeg(angleDeg, drag.free ? FREE_STEP_DEG : STEP_DEG);
}

/** That angle with the place about which it turns. */
export function draggedTurn(drag: Drag, scene: Scene, selection: Selection): Turn | null {
  const [byDeg, about] = [draggedAngle(drag, scene, selection), middleOfSelection(scene, selection)];
  return byDeg === null || about === null ? null : { byDeg, about };
}
