import { endOf, isTap, startOf } from '../drag';
import { adding } from '../edits';
import { freeIds } from '../ids';
import { distanceMm, toVec } from '../plane';
import { isInArena, snapMarks, snappedLine, wallAttractors, type SnappedLine } from '../snap';
import { lured } from '../snap/attract';
import type { Drag, Mark, Tool, ToolContext } from './tool';

/** A shorter drag was not meant as a wall. Chosen: half the usual thickness. */
const SHORTEST_MM = 5;

/** Draws a wall from where the drag begins to where it ends. */
export const wallTool: Tool = {
  id: 'wall',
  cursor: 'crosshair',
  edit(drag, context) {
    const { scene, options } = context;
    if (isTap(drag) || !isInArena(startOf(drag), scene.size, drag.reachMm)) return null;
    const { from, to } = lineOf(drag, context);
    if (distanceMm(toVec(from), toVec(to)) < SHORTEST_MM) return null;
    return adding(scene, [{ type: 'wall', id: freeIds(scene)('wall'), from, to, thickness: options.wallThickness }]);
  },
  marks(drag, context): readonly Mark[] {
    if (!isInArena(startOf(drag), context.scene.size, drag.reachMm)) return [];
    return snapMarks(lineOf(drag, context), !isTap(drag));
  },
};

function lineOf(drag: Drag, context: ToolContext): SnappedLine {
  const { scene, options } = context;
  return snappedLine(startOf(drag), endOf(drag), wallAttractors(scene), {
    lure: lured(drag, context).lure,
    size: scene.size,
    reachMm: drag.reachMm,
    free: drag.free || !options.wallSnaps,
  });
}
