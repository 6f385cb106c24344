import type { SceneEdit } from '#scene/edit';
import { isTap, startOf } from '../drag';
import { addingOnce } from '../edits';
import { kindOf, newObject } from '../kinds/index';
import { toPoint } from '../plane';
import { intoArena, isInArena } from '../snap';
import { withLure, snappedObject } from '../snap/attract';
import { cornerByCorner, cornerPolygon, setsCorners, type Wish } from './corner-polygon';
import type { Drag, Tool, ToolContext } from './tool';

/**
 * Puts a block, fixed block, spikes or mover: a tap in the size of the options, a drag in its own size or track. A polygon
 * is drawn by its outline, or tap by tap by its corners.
 */
export const blockTool: Tool = {
  id: 'block',
  putsDown: true,
  cursor: 'crosshair',
  edit: (drag, context) => putting(wishOf(context), drag, context),
  ...cornerByCorner((context) => wishOf(context)),
};

const wishOf = ({ options }: ToolContext): Wish => ({ type: options.block, shape: options.blockShape });

/** Puts an object where a drag begins: by a tap as the options have it, otherwise as large as the drag. */
export function putting(wish: Wish, drag: Drag, context: ToolContext): SceneEdit | null {
  const { type } = wish;
  if (setsCorners(wish, drag)) return cornerPolygon(wish, drag, context);
  const { scene, options } = context;
  const start = startOf(drag);
  if (!isInArena(start, scene.size, drag.reachMm)) return null;
  const object = newObject(scene, type, toPoint(intoArena(start, scene.size)), options);
  const put = object && snappedObject(object, drag, context);
  const dragged = put && !isTap(drag) ? kindOf(put).dragged?.(put, withLure(drag, context), scene.size) : null;
  return put && addingOnce(scene, dragged ?? put);
}
