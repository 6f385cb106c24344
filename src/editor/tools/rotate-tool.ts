import type { SceneEdit } from '#scene/edit';
import { turnedByEighths, turnedBy } from '../arrange';
import { isTap, startOf } from '../drag';
import { draggedAngle, draggedTurn } from '../handle-drag';
import { includes, takenBy, thingsAt } from '../selection';
import type { Drag, Selection, Tool, ToolContext, Turn } from './tool';

/**
 * Turns what it is used on about its middle: a tap by 45° counter-clockwise, a drag in steps. What is selected together
 * turns together.
 */
export const rotateTool: Tool = {
  id: 'rotate',
  cursor: 'alias',
  edit(drag, context): SceneEdit | null {
    const { scene, footprint } = context;
    const meant = meantBy(drag, context);
    if (!meant) return null;
    if (isTap(drag)) return turnedByEighths(scene, meant, 1, footprint);
    const angleDeg = draggedAngle(drag, scene, meant);
    return angleDeg === null ? null : turnedBy(scene, meant, angleDeg, footprint);
  },
  turns(drag, context): Turn | null {
    const meant = isTap(drag) ? null : meantBy(drag, context);
    return meant && draggedTurn(drag, context.scene, meant);
  },
  select: (drag, context) => meantBy(drag, context) ?? context.selection,
};

/** The selection if the drag began on a part of it, else what a tap on the topmost thing there takes; `null` when it began on nothing. */
function meantBy(drag: Drag, { scene, selection, footprint }: ToolContext): Selection | null {
  const things = thingsAt(scene, startOf(drag), drag.reachMm, footprint);
  const [topmost] = things;
  if (topmost === undefined) return null;
  return things.some((thing) => includes(selection, thing)) ? selection : takenBy(scene, topmost, selection);
}
