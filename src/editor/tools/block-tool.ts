import type { SceneEdit } from '#scene/edit';
import type { SceneObject } from '#scene/scene';
import { isTap, startOf } from '../drag';
import { addingOnce } from '../edits';
import { kindOf, newObject } from '../kinds/index';
import { toPoint } from '../plane';
import { intoArena, isInArena, onGrid } from '../snap';
import type { Drag, Tool, ToolContext } from './tool';

/** Puts a block, fixed block, spikes or mover: a tap in the size of the options, a drag in its own size or track. */
export const blockTool: Tool = {
  id: 'block',
  cursor: 'crosshair',
  edit: (drag, context) => putting(context.options.block, drag, context),
};

/** Puts an object where a drag begins: by a tap as the options have it, otherwise as large as the drag. */
export function putting(type: SceneObject['type'], drag: Drag, { scene, options }: ToolContext): SceneEdit | null {
  const start = startOf(drag);
  if (!isInArena(start, scene.size, drag.reachMm)) return null;
  const at = toPoint(intoArena(drag.free ? start : onGrid(start, drag.reachMm), scene.size));
  const object = newObject(scene, type, at, options);
  const dragged = object && !isTap(drag) ? kindOf(object).dragged?.(object, drag, scene.size) : null;
  return object && addingOnce(scene, dragged ?? object);
}
