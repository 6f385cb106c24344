import type { Vec } from '#core/geometry';
import { isSame } from '#core/same';
import { squaredDistance, type Bounds } from '#scene/outline';
import { sceneLimits, type Point } from '#scene/scene';
import { endOf, isTap, startOf } from '../drag';
import { distanceMm, toPoint, toVec, within } from '../plane';
import { onGrid, snappedLine, strokeEnds, type Attractors } from '../snap';
import type { Drag, ToolContext } from '../tools/tool';
import { chainOf, placesOf, type Chain } from './corners';
import { arcThrough, oval, roundedRectangle } from './curves';
import { inWholeMm } from './whole-mm';

const attractors = ({ scene }: ToolContext): Attractors => ({ ends: strokeEnds(scene), walls: [] });

/** The corners of a line that is drawn by clicks. */
export const penChain = (drag: Drag, context: ToolContext): Chain => chainOf(drag, context, attractors(context));

/** A line from corner to corner. */
export function polyline(drag: Drag, context: ToolContext): readonly Point[] {
  const { corners, isClosed } = penChain(drag, context);
  return isClosed ? [...corners, ...corners.slice(0, 1)] : corners;
}

/** An arc has two ends and a place that it passes. */
const ARC_PLACES = 3;

/** True if an arc is complete: by its third click, by a second one on its beginning, or by a drag that bends. */
export const isArcDone = (drag: Drag): boolean =>
  drag.corners === undefined ? !isTap(drag) && bendOf(drag) !== null : isArcEnded(drag);

function isArcEnded({ path, reachMm }: Drag): boolean {
  const [start, end] = path;
  // A second tap on the beginning ends it there.
  return path.length >= ARC_PLACES || (start !== undefined && end !== undefined && distanceMm(start, end) <= reachMm);
}

/** An arc from the first place to the second through the third: that of the last click, or where the drag bent most. */
export function arcOf(drag: Drag, { scene, options }: ToolContext): readonly Point[] {
  const [start, end] = placesOf(drag);
  if (!start) return [];
  const ends = { ends: strokeEnds(scene), walls: [] };
  const rules = { size: scene.size, reachMm: drag.reachMm, free: drag.free };
  const { from } = snappedLine(start, start, ends, rules);
  if (!end || (drag.corners !== undefined && distanceMm(start, end) <= drag.reachMm)) return [from];
  const through = drag.corners === undefined ? bendOf(drag) : (drag.path[ARC_PLACES - 1] ?? null);
  // Both ends are attracted, but not to the eight directions of a straight line.
  const to = snappedLine(end, end, ends, rules).from;
  if (isSame(from, to)) return [from];
  const isFlat = !through || Math.sqrt(squaredDistance(through, toVec(from), toVec(to))) < options.penWidth / 10;
  return inWholeMm(isFlat ? [toVec(from), toVec(to)] : arcThrough(toVec(from), toVec(to), through)).map(kept);
}

/** The place of a drag that is furthest from the straight line between its ends; `null`: it goes straight. */
function bendOf(drag: Drag): Vec | null {
  const [start, end] = [startOf(drag), endOf(drag)];
  let furthest: Vec | null = null;
  let most = (drag.reachMm / 2) * (drag.reachMm / 2);
  for (const place of drag.path) {
    const squared = squaredDistance(place, start, end);
    if (squared <= most) continue;
    furthest = place;
    most = squared;
  }
  return furthest;
}

/** Radius of the corners of a rounded rectangle, in mm. Chosen: a curve that all robots follow; less in a small one. */
const CORNER_MM = 100;

/** The shortest side of a shape, in mm: what is smaller was not meant. */
const SMALLEST_MM = 10;

/** The line round the rectangle that a drag spans: a circle, an oval, or with its corners rounded. */
export function roundShape(drag: Drag, { options }: ToolContext): readonly Point[] {
  const bounds = spanned(drag, options.penShape === 'circle' || drag.keeps === true);
  const shorter = Math.min(bounds.maxX - bounds.minX, bounds.maxY - bounds.minY);
  if (shorter < SMALLEST_MM) return [];
  if (options.penShape !== 'rounded') return inWholeMm(oval(bounds)).map(kept);
  const points = roundedRectangle(bounds, Math.min(CORNER_MM, Math.floor(shorter / 3))).flatMap(inWholeMm);
  return [...points, ...points.slice(0, 1)].map(kept);
}

/** The rectangle of a drag, from corner to corner or from its middle; `isEven`: a square. In whole mm. */
function spanned(drag: Drag, isEven: boolean): Bounds {
  const place = (at: Vec): Vec => toVec(toPoint(drag.free ? at : onGrid(at, drag.reachMm)));
  const [from, end] = [place(startOf(drag)), place(endOf(drag))];
  const side = Math.max(Math.abs(end.x - from.x), Math.abs(end.y - from.y));
  const to = isEven ? { x: from.x + signed(side, end.x - from.x), y: from.y + signed(side, end.y - from.y) } : end;
  const start = drag.alt === true ? { x: 2 * from.x - to.x, y: 2 * from.y - to.y } : from;
  return {
    minX: Math.min(start.x, to.x),
    minY: Math.min(start.y, to.y),
    maxX: Math.max(start.x, to.x),
    maxY: Math.max(start.y, to.y),
  };
}

const signed = (size: number, like: number): number => (like < 0 ? -size : size);

/** A point within what a course may hold. */
const kept = ([x, y]: Point): Point => [within(x, sceneLimits.placeMm), within(y, sceneLimits.placeMm)];
