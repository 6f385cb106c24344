import type { Point } from '#scene/scene';
import { endOf, isTap, startOf } from '../drag';
import { adding } from '../edits';
import { freeIds } from '../ids';
import { newWallLook } from '../kinds/wall';
import { chainMarks, chainOf, type Chain } from '../lines/corners';
import { distanceMm, toVec } from '../plane';
import { isInArena, snapMarks, snappedLine, wallAttractors, type SnappedLine } from '../snap';
import { withLure } from '../snap/attract';
import type { Drag, Mark, Tool, ToolContext } from './tool';

/** A shorter drag was not meant as a wall. Chosen: half the usual thickness. */
const SHORTEST_MM = 5;

/** Draws a wall from where the drag begins to where it ends, or walls from tap to tap. */
export const wallTool: Tool = {
  id: 'wall',
  cursor: 'crosshair',
  edit(drag, context) {
    const { scene, options } = context;
    const idOf = freeIds(scene);
    const walls = sidesOf(drag, context)
      .filter(([from, to]) => distanceMm(toVec(from), toVec(to)) >= SHORTEST_MM)
      .map(([from, to]) => ({ type: 'wall', id: idOf('wall'), from, to, ...newWallLook(options) }) as const);
    return adding(scene, walls);
  },
  goesOn: (drag, context) => (isOneWall(drag) ? false : !wallChain(drag, context).isDone),
  marks(drag, context): readonly Mark[] {
    if (drag.corners !== undefined) return chainMarks(drag, wallChain(drag, context));
    if (!isInArena(startOf(drag), context.scene.size, drag.reachMm)) return [];
    return snapMarks(lineOf(drag, context), !isTap(drag));
  },
};

/** A drag draws one wall; a tap begins with the first of several corners. */
const isOneWall = (drag: Drag): boolean => drag.corners === undefined && !isTap(drag);

const wallChain = (drag: Drag, context: ToolContext): Chain =>
  chainOf(drag, context, wallAttractors(context.scene), drag.free || !context.options.wallSnaps);

/** The ends of the walls that a drag amounts to. */
function sidesOf(drag: Drag, context: ToolContext): readonly (readonly [Point, Point])[] {
  if (isOneWall(drag)) {
    if (!isInArena(startOf(drag), context.scene.size, drag.reachMm)) return [];
    const { from, to } = lineOf(drag, context);
    return [[from, to]];
  }
  const { corners, isClosed } = wallChain(drag, context);
  const ends = isClosed ? [...corners, ...corners.slice(0, 1)] : corners;
  return ends.slice(1).map((to, index) => [ends[index] ?? to, to]);
}

function lineOf(drag: Drag, context: ToolContext): SnappedLine {
  const { scene, options } = context;
  return snappedLine(startOf(drag), endOf(drag), wallAttractors(scene), {
    lure: withLure(drag, context).lure,
    size: scene.size,
    reachMm: drag.reachMm,
    free: drag.free || !options.wallSnaps,
  });
}
