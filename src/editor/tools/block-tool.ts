import type { SceneEdit } from '#scene/edit';
import type { SceneObject } from '#scene/scene';
import { isTap, startOf } from '../drag';
import { addingOnce } from '../edits';
import { kindOf, newObject } from '../kinds/index';
import { toPoint } from '../plane';
import { intoArena, isInArena } from '../snap';
import { lured, snappedObject } from '../snap/attract';
import type { Drag, Tool, ToolContext } from './tool';

/** Puts a block, fixed block, spikes or mover: a tap in the size of the options, a drag in its own size or track. */
export const blockTool: Tool = {
  id: 'block',
  putsDown: true,
  cursor: 'crosshair',
  edit: (drag, context) => putting(context.options.block, drag, context),
};

/** Puts an object where a drag begins: by a tap as the options have it, otherwise as large as the drag. */
export function putting(type: SceneObject['type'], drag: Drag, context: ToolContext): SceneEdit | null {
  const { scene, options } = context;
  const start = startOf(drag);
  if (!isInArena(start, scene.size, drag.reachMm)) return null;
  const object = newObject(scene, type, toPoint(intoArena(start, scene.size)), options);
  const put = object && snappedObject(object, drag, context);
  const dragged = put && !isTap(drag) ? kindOf(put).dragged?.(put, lured(drag, context), scene.size) : null;
  return put && addingOnce(scene, dragged ?? put);
}
