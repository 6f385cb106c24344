import type { SceneEdit } from '#scene/edit';
import type { SceneObject, Shaped } from '#scene/scene';
import type { ShapeName } from '#scene/shape/shape';
import { isTap } from '../drag';
import { addingOnce } from '../edits';
import { newObject } from '../kinds/index';
import { drawnPolygon } from '../kinds/shapes';
import { chainMarks, chainOf, type Chain } from '../lines/corners';
import { toVec } from '../plane';
import type { Attractors } from '../snap';
import type { Drag, Mark, Tool, ToolContext } from './tool';

/** The type and the shape of the object that a tool is set to put. */
export interface Wish {
  readonly type: SceneObject['type'];
  readonly shape: ShapeName;
}

/** The grid and what lies near attract corners; lines do not. */
const nothingElse: Attractors = { ends: [], walls: [] };

const chain = (drag: Drag, context: ToolContext): Chain => chainOf(drag, context, nothingElse);

/** True if a gesture sets the corners of a polygon one by one: it began with a tap. A drag draws the outline in one go. */
export const setsCorners = ({ type, shape }: Wish, drag: Drag): boolean =>
  shape === 'polygon' && type !== 'mover' && (drag.corners !== undefined || isTap(drag));

/** Puts the polygon through the corners so far; `null`: they enclose nothing. */
export function cornerPolygon({ type }: Wish, drag: Drag, context: ToolContext): SceneEdit | null {
  const { scene, options } = context;
  const polygon = drawnPolygon(chain(drag, context).corners.map(toVec), scene.size);
  const object = polygon && newObject(scene, type, polygon.at, options);
  return object && addingOnce(scene, { ...(object as SceneObject & Shaped), ...polygon });
}

/** The part of a tool that goes on from corner to corner, with the marks meanwhile; `wishOf` reads its options. */
export const cornerByCorner = (wishOf: (context: ToolContext) => Wish): Required<Pick<Tool, 'goesOn' | 'marks'>> => ({
  goesOn: (drag, context) => setsCorners(wishOf(context), drag) && !chain(drag, context).isDone,
  marks(drag, context): readonly Mark[] {
    if (drag.corners === undefined || !setsCorners(wishOf(context), drag)) return [];
    const found = chain(drag, context);
    return [{ type: 'lasso', path: found.corners.map(toVec) }, ...chainMarks(drag, found)];
  },
});
