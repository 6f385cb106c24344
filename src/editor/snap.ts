import type { Vec } from '#core/geometry';
import type { Point, Scene, Wall } from '#scene/scene';
import type { Drag, Lure, Mark } from './tools/tool';
import { distanceMm, nearestOn, toPoint, toVec, within } from './plane';

/** Distance of the lines that attract what is put down or moved, in mm. Chosen: the finest lines of the arena's grid. */
export const GRID_MM = 10;

/**
 * Ends and walls attract no farther than this, in mm, also where a finger on a small screen reaches farther. Chosen: half
 * of the smallest cell of a maze, so that walls can be drawn side by side.
 */
export const ATTRACTS_MM = 25;

/** A coordinate drawn onto the nearest grid line if that is within reach. */
export function gridMm(mm: number, reachMm: number): number {
  const line = Math.round(mm / GRID_MM) * GRID_MM;
  return Math.abs(line - mm) <= reachMm ? line : mm;
}

/** A place drawn onto the nearest grid lines within reach, each coordinate on its own. */
export const onGrid = ({ x, y }: Vec, reachMm: number): Vec => ({ x: gridMm(x, reachMm), y: gridMm(y, reachMm) });

/** A place drawn onto the nearest thing, else the nearest grid line, each coordinate on its own; unchanged if free. */
export const snappedPlace = ({ x, y }: Vec, { free, reachMm, lure }: Omit<Drag, 'path' | 'adds'>): Vec =>
  free ? { x, y } : { x: lure?.(x, 'x') ?? gridMm(x, reachMm), y: lure?.(y, 'y') ?? gridMm(y, reachMm) };

/** A place kept inside the arena, its edge included. */
export const intoArena = ({ x, y }: Vec, [width, height]: Point): Vec => ({
  x: within(x, { min: 0, max: width }),
  y: within(y, { min: 0, max: height }),
});

/** True if a place is in the arena or at most this far from its edge. */
export const isInArena = ({ x, y }: Vec, [width, height]: Point, marginMm = 0): boolean =>
  x >= -marginMm && y >= -marginMm && x <= width + marginMm && y <= height + marginMm;

/** The place nearest to `to` in one of the eight directions from `from`; diagonals keep both coordinates equally far. */
export function alongEighths(from: Vec, to: Vec): Vec {
  const dx = to.x - from.x;
  const dy = to.y - from.y;
  const far = Math.max(Math.abs(dx), Math.abs(dy));
  const near = Math.min(Math.abs(dx), Math.abs(dy));
  if (near <= far * TAN_22_5) {
    return Math.abs(dx) >= Math.abs(dy) ? { x: to.x, y: from.y } : { x: from.x, y: to.y };
  }
  const aside = (far + near) / 2; // the foot of the perpendicular onto the diagonal
  return { x: from.x + (dx < 0 ? -aside : aside), y: from.y + (dy < 0 ? -aside : aside) };
}

/** Tangent of 22.5°, half way between a straight and a diagonal direction: √2 − 1. */
const TAN_22_5 = Math.SQRT2 - 1;

/** A straight line that is being drawn, with what it has snapped to. */
export interface SnappedLine {
  readonly from: Point;
  readonly to: Point;
  /** Ends of it that lie on another line. */
  readonly snaps: readonly Vec[];
}

/** The places that a line may snap to. */
export interface Attractors {
  /** Ends of other lines. */
  readonly ends: readonly Point[];
  /** Walls whose middle line attracts as well. */
  readonly walls: readonly Wall[];
}

/** The marks of what a line has snapped to; while nothing is drawn yet only of its beginning. */
export const snapMarks = ({ snaps }: SnappedLine, isBegun: boolean): readonly Mark[] =>
  (isBegun ? snaps : snaps.slice(0, 1)).map((at) => ({ type: 'snap', at }));

/** The rules by which the ends of a line snap. */
export interface LineRules {
  readonly size: Point;
  readonly reachMm: number;
  /** Nothing attracts, any direction. */
  readonly free: boolean;
  /** Edges and middles of things, which attract the ends of lines along the axes. */
  readonly lure?: Lure | undefined;
}

/**
 * The line that is meant by a drag from one place to another. Its ends go to ends of other lines first, then onto the
 * middle line of a wall, then to one of the eight directions and the grid. Both lie inside the arena.
 */
export function snappedLine(start: Vec, end: Vec, to: Attractors, rules: LineRules): SnappedLine {
  const { size, free } = rules;
  const reachMm = Math.min(rules.reachMm, ATTRACTS_MM);
  if (free) {
    const from = intoArena(start, size);
    return { from: toPoint(from), to: toPoint(shortenedInto(from, end, size)), snaps: [] };
  }
  const first = snappedStart(intoArena(start, size), to, { ...rules, reachMm });
  const from = toVec(toPoint(intoArena(first.at, size)));
  const last = snappedEnd(from, end, to, { ...rules, reachMm });
  return {
    from: toPoint(from),
    to: toPoint(last.at),
    snaps: [...(first.isSnapped ? [from] : []), ...(last.isSnapped ? [last.at] : [])],
  };
}

/**
 * The snapped place of a line's end whose other end stays: as with `snappedLine`.
 *
 * @returns the place in whole mm inside the arena
 */
export function snappedTo(from: Point, place: Vec, to: Attractors, rules: LineRules): Point {
  const { size, free } = rules;
  const start = intoArena(toVec(from), size);
  if (free) return toPoint(shortenedInto(start, place, size));
  return toPoint(snappedEnd(start, place, to, { ...rules, reachMm: Math.min(rules.reachMm, ATTRACTS_MM) }).at);
}

interface Snapped {
  readonly at: Vec;
  readonly isSnapped: boolean;
}

function snappedStart(place: Vec, { ends, walls }: Attractors, rules: LineRules): Snapped {
  const { reachMm } = rules;
  const end = nearestEnd(ends, place, reachMm);
  if (end) return { at: end, isSnapped: true };
  const beside = nearestOf(
    walls
      .filter((wall) => isNear(wall, place, reachMm))
      .map((wall) => nearestOn(toVec(wall.from), toVec(wall.to), place)),
    place,
    reachMm,
  );
  return beside ? { at: beside, isSnapped: true } : { at: snappedPlace(place, rules), isSnapped: false };
}

function snappedEnd(from: Vec, place: Vec, { ends, walls }: Attractors, rules: LineRules): Snapped {
  const { size, reachMm, lure } = rules;
  const end = nearestEnd(ends, intoArena(place, size), reachMm);
  if (end && distanceMm(end, from) > 0) return { at: end, isSnapped: true };
  const straight = shortenedInto(from, alongEighths(from, place), size);
  const crossings = walls
    .filter((wall) => isNear(wall, straight, reachMm))
    .flatMap((wall) => crossing(from, straight, wall) ?? []);
  const crossed = nearestOf(crossings, straight, reachMm);
  if (crossed) return { at: crossed, isSnapped: true };
  return { at: shortenedInto(from, wholeCentimetres(from, straight, reachMm, lure), size), isSnapped: false };
}

/**
 * The end of a line in one of the eight directions: brought to a thing or a grid line, or to whole cm of both sides if
 * diagonal.
 */
export function wholeCentimetres(from: Vec, to: Vec, reachMm: number, lure?: Lure): Vec {
  if (to.x === from.x) return { x: to.x, y: lure?.(to.y, 'y') ?? gridMm(to.y, reachMm) };
  if (to.y === from.y) return { x: lure?.(to.x, 'x') ?? gridMm(to.x, reachMm), y: to.y };
  const aside = Math.abs(to.x - from.x);
  const whole = gridMm(aside, reachMm);
  return { x: from.x + (to.x < from.x ? -whole : whole), y: from.y + (to.y < from.y ? -whole : whole) };
}

/** The point where the line from a place in the arena leaves it, or the line's end. */
export function shortenedInto(from: Vec, to: Vec, [width, height]: Point): Vec {
  const dx = to.x - from.x;
  const dy = to.y - from.y;
  const share = Math.min(
    1,
    dx > 0 ? (width - from.x) / dx : dx < 0 ? from.x / -dx : 1,
    dy > 0 ? (height - from.y) / dy : dy < 0 ? from.y / -dy : 1,
  );
  return share === 1 ? to : { x: from.x + dx * share, y: from.y + dy * share };
}

/** The point where a line, also extended at its end, meets the middle line of a wall; `null` if it does not. */
function crossing(from: Vec, to: Vec, wall: Wall): Vec | null {
  const a = toVec(wall.from);
  const way = { x: to.x - from.x, y: to.y - from.y };
  const along = { x: wall.to[0] - a.x, y: wall.to[1] - a.y };
  const cross = way.x * along.y - way.y * along.x;
  if (cross === 0) return null;
  const share = ((a.x - from.x) * way.y - (a.y - from.y) * way.x) / cross;
  const onWay = ((a.x - from.x) * along.y - (a.y - from.y) * along.x) / cross;
  if (share < 0 || share > 1 || onWay <= 0) return null;
  return { x: from.x + way.x * onWay, y: from.y + way.y * onWay };
}

/** True if the rectangle around a wall's middle line is within reach: four comparisons rule most walls out. */
const isNear = ({ from, to }: Wall, { x, y }: Vec, reachMm: number): boolean =>
  Math.min(from[0], to[0]) - reachMm <= x &&
  Math.max(from[0], to[0]) + reachMm >= x &&
  Math.min(from[1], to[1]) - reachMm <= y &&
  Math.max(from[1], to[1]) + reachMm >= y;

function nearestOf(places: readonly Vec[], to: Vec, reachMm: number): Vec | null {
  let best: Vec | null = null;
  let bestMm = reachMm;
  for (const place of places) {
    const mm = distanceMm(place, to);
    if (mm > bestMm) continue;
    best = place;
    bestMm = mm;
  }
  return best;
}

function nearestEnd(ends: readonly Point[], place: Vec, reachMm: number): Vec | null {
  let best: Point | null = null;
  let bestMm = reachMm;
  for (const end of ends) {
    // Most are far away: two subtractions rule them out.
    if (Math.abs(end[0] - place.x) > bestMm || Math.abs(end[1] - place.y) > bestMm) continue;
    const mm = distanceMm(toVec(end), place);
    if (mm > bestMm) continue;
    best = end;
    bestMm = mm;
  }
  return best === null ? null : toVec(best);
}

const attractorsOf = new WeakMap<Scene, Attractors>();

/** The places that a wall snaps to: all walls, cached per course. */
export function wallAttractors(scene: Scene): Attractors {
  const known = attractorsOf.get(scene);
  if (known) return known;
  const walls = scene.objects.filter((object) => object.type === 'wall');
  const attractors = { ends: walls.flatMap(({ from, to }) => [from, to]), walls };
  attractorsOf.set(scene, attractors);
  return attractors;
}

/** Snap targets for a wall whose end is moved: all other walls. */
export function otherWalls(scene: Scene, { id }: Pick<Wall, 'id'>): Attractors {
  const walls = wallAttractors(scene).walls.filter((wall) => wall.id !== id);
  return { ends: walls.flatMap(({ from, to }) => [from, to]), walls };
}

/** The ends of all strokes. */
export function strokeEnds(scene: Scene): readonly Point[] {
  const ends: Point[] = [];
  for (const object of scene.objects) {
    if (object.type !== 'stroke') continue;
    const first = object.points[0];
    const last = object.points[object.points.length - 1];
    if (first) ends.push(first);
    if (last && last !== first) ends.push(last);
  }
  return ends;
}
