import { wrappedDeg } from '#core/angle';
import type { Vec } from '#core/geometry';
import type { SceneEdit } from '#scene/edit';
import type { Point, Scene } from '#scene/scene';
import { middleOfSelection, turnedBy } from './arrange';
import { sizedTogether } from './arranging/scale';
import { endOf, startOf } from './drag';
import { changing } from './edits';
import { handleAt } from './handles';
import { kindOf } from './kinds/index';
import { puttingJoined } from './lines/join-lines';
import { directionDeg, distanceMm, minus, plus, steppedDeg } from './plane';
import { withLure } from './snap/attract';
import { countOf, freeObjects } from './selection';
import type { Drag, Handle, Selection, ToolContext, Turn } from './tools/tool';

/** The edit that a drag of a handle makes; `null`: nothing changes. */
export function handleDragged(handle: Handle, drag: Drag, context: ToolContext): SceneEdit | null {
  const { scene, selection, footprint } = context;
  if (handle.kind === 'rotate') {
    const angleDeg = draggedAngle(drag, scene, selection);
    return angleDeg === null ? null : turnedBy(scene, selection, angleDeg, footprint);
  }
  // A thing that is grabbed beside its middle keeps that distance.
  const place = plus(handle.at, minus(endOf(drag), startOf(drag)));
  const snapping = withLure(drag, context, selection);
  if (handle.kind === 'size') return sized(handle, place, snapping, context);
  const object = scene.objects.find(({ id }) => id === handle.id);
  if (!object) return null;
  const kind = kindOf(object);
  const changed =
    handle.kind === 'point' || handle.kind === 'add'
      ? kind.pointMoved?.(object, handle, place, snapping, scene)
      : kind.endMoved?.(object, handle.kind, place, snapping, scene);
  if (changed?.type === 'stroke' && !drag.free) return puttingJoined(scene, changed);
  return changed ? changing([changed]) : null;
}

/** Sizes one thing in its own manner if its kind has one, otherwise all that is selected together. */
function sized({ side = UPPER_RIGHT }: Handle, place: Vec, drag: Drag, context: ToolContext): SceneEdit | null {
  const { scene, selection } = context;
  const [only] = countOf(selection) === 1 ? freeObjects(scene, selection) : [];
  const kind = only && kindOf(only);
  if (!only || !kind?.sized) return sizedTogether(side, place, drag, context);
  const changed = kind.sized(only, side, place, drag);
  return changed && changing([changed]);
}

const UPPER_RIGHT: Point = [1, 1];

/** Takes out the point of a selected thing whose handle is at a place; `null`: there is none, or it has to stay. */
export function handlePointRemoved(
  { scene, selection, footprint }: ToolContext,
  at: Vec,
  reachMm: number,
): SceneEdit | null {
  const handle = handleAt(scene, selection, footprint, at, reachMm);
  const object = scene.objects.find(({ id }) => id === handle?.id);
  if (!object || handle?.kind !== 'point' || handle.index === undefined) return null;
  const rest = kindOf(object).withoutPoint?.(object, handle.index);
  return rest ? changing([rest]) : null;
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

/** The angle of `draggedAngle`, with the place about which it turns. */
export function draggedTurn(drag: Drag, scene: Scene, selection: Selection): Turn | null {
  const [byDeg, about] = [draggedAngle(drag, scene, selection), middleOfSelection(scene, selection)];
  return byDeg === null || about === null ? null : { byDeg, about };
}
