import type { Vec } from '#core/geometry';
import { sceneLimits, type Point } from '#scene/scene';
import { endOf, startOf } from './drag';
import { toPoint, within } from './plane';
import { intoArena, onGrid } from './snap';
import type { Drag } from './tools/tool';

/** Sides that a dragged box has at least, in mm. Chosen: what can still be seen and taken hold of. */
const SMALLEST_MM = 10;

/** Middle and extent of the upright box between where a drag began and where it is, inside the arena. */
export function draggedBox(drag: Drag, arena: Point): { readonly at: Point; readonly size: Point } {
  const [a, b] = [startOf(drag), endOf(drag)].map((place) =>
    intoArena(drag.free ? place : onGrid(place, drag.reachMm), arena),
  ) as [Vec, Vec];
  return {
    at: toPoint({ x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 }),
    size: [boxSide(Math.abs(b.x - a.x), SMALLEST_MM), boxSide(Math.abs(b.y - a.y), SMALLEST_MM)],
  };
}

/** A side in whole mm within what a course may hold. */
export const boxSide = (mm: number, leastMm: number = sceneLimits.blockMm.min): number =>
  Math.round(within(mm, { min: leastMm, max: sceneLimits.blockMm.max }));

/** Where the middle of something goes that is put by a tap. */
export function tappedMiddle(drag: Drag, arena: Point): Point {
  const place = startOf(drag);
  return toPoint(intoArena(drag.free ? place : onGrid(place, drag.reachMm), arena));
}
