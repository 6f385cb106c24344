import type { Vec } from '#core/geometry';
import { isSame } from '#core/same';
import type { Point } from '#scene/scene';
import { endOf, isTap, startOf } from '../drag';
import { distanceMm, toVec } from '../plane';
import { isInArena, snappedLine, snappedTo, type Attractors } from '../snap';
import { withLure } from '../snap/attract';
import type { Drag, Mark, ToolContext } from '../tools/tool';

/** A line that is drawn corner by corner, as far as it has come. */
export interface Chain {
  /** In whole mm, inside the arena; a closed one does not repeat its first. */
  readonly corners: readonly Point[];
  /** The last place is on the first corner. */
  readonly isClosed: boolean;
  /** The last place is on a corner that ends it. */
  readonly isDone: boolean;
}

const nothing: Chain = { corners: [], isClosed: false, isDone: true };

/** Corners from which on a chain can be closed: as many make an area. */
const CLOSES_FROM = 3;

/**
 * The corners of a drag: those that are set, and its present place. Each snaps as the end of a line from the one before.
 * On the corner before it ends the chain, and on the first one it closes it.
 */
export function chainOf(drag: Drag, context: ToolContext, to: Attractors, free = drag.free): Chain {
  const { size } = context.scene;
  const places = placesOf(drag);
  const [start] = places;
  if (!start || !isInArena(start, size, drag.reachMm)) return nothing;
  const rules = { size, reachMm: drag.reachMm, free, lure: withLure(drag, context).lure };
  const corners: Point[] = [snappedLine(start, start, to, rules).from];
  for (const place of places.slice(1)) {
    const [first, last] = [corners[0], corners[corners.length - 1]];
    if (!first || !last) break;
    if (isOn(place, last, drag)) return { corners, isClosed: false, isDone: true };
    if (corners.length >= CLOSES_FROM && isOn(place, first, drag)) return { corners, isClosed: true, isDone: true };
    const next = snappedTo(last, place, to, rules);
    if (!isSame(next, last)) corners.push(next);
  }
  return { corners, isClosed: false, isDone: false };
}

const isOn = (place: Vec, corner: Point, { reachMm }: Drag): boolean => distanceMm(place, toVec(corner)) <= reachMm;

/** The corners as they were pointed at, without snapping: of a first tap its place, of a first drag its two ends. */
export function placesOf(drag: Drag): readonly Vec[] {
  if (drag.corners !== undefined) return drag.path;
  return isTap(drag) ? [startOf(drag)] : [startOf(drag), endOf(drag)];
}

/** Rings around the corners that end a chain: its last one set, and the first where that closes it. */
export function chainMarks(drag: Drag, { corners }: Chain): readonly Mark[] {
  const set = drag.corners ?? 0;
  const ends = [corners[set - 1], set >= CLOSES_FROM ? corners[0] : undefined];
  return ends.filter((at) => at !== undefined).map((at) => ({ type: 'snap', at: toVec(at) }));
}
