import type { Vec } from '#core/geometry';
import type { Label, Mover, Point, SceneObject, Stroke, Wall, Zone } from './scene';

/** A convex outline in mm, counter-clockwise or clockwise. */
export type Outline = readonly Vec[];

/** A rectangle along the axes, in mm. */
export interface Bounds {
  readonly minX: number;
  readonly minY: number;
  readonly maxX: number;
  readonly maxY: number;
}

/** What lies in the arena as a turned rectangle: its centre, extent along its own x and y, and rotation in eighths. */
export interface Box {
  readonly at: Point;
  readonly size: Point;
  readonly turn: number;
}

const DIAGONAL = Math.SQRT1_2;

/** Cosine and sine of each eighth of a turn, exact where they can be. */
const EIGHTHS: readonly Vec[] = [
  { x: 1, y: 0 },
  { x: DIAGONAL, y: DIAGONAL },
  { x: 0, y: 1 },
  { x: -DIAGONAL, y: DIAGONAL },
  { x: -1, y: 0 },
  { x: -DIAGONAL, y: -DIAGONAL },
  { x: 0, y: -1 },
  { x: DIAGONAL, y: -DIAGONAL },
];

const AHEAD: Vec = { x: 1, y: 0 };

/** The direction of a box's own x axis: a vector of length 1. */
export const directionOf = (turn: number): Vec => EIGHTHS[turn & 7] ?? AHEAD;

/** The outline of what a robot bumps into, in world mm (a mover: where it starts); `null` for what lies flat on the floor. */
export function solidOutline(object: SceneObject): Outline | null {
  switch (object.type) {
    case 'wall':
      return wallOutline(object);
    case 'block':
    case 'fixed-block':
    case 'spikes':
    case 'mover':
      return boxOutline(object);
    case 'stroke':
    case 'target':
    case 'checkpoint':
    case 'forbidden':
    case 'label':
      return null;
    default:
      return object satisfies never;
  }
}

function wallOutline({ from, to, thickness }: Wall): Outline {
  const dx = to[0] - from[0];
  const dy = to[1] - from[1];
  const half = thickness / 2 / lengthOf(dx, dy);
  const acrossX = -dy * half;
  const acrossY = dx * half;
  return [
    { x: from[0] - acrossX, y: from[1] - acrossY },
    { x: to[0] - acrossX, y: to[1] - acrossY },
    { x: to[0] + acrossX, y: to[1] + acrossY },
    { x: from[0] + acrossX, y: from[1] + acrossY },
  ];
}

/** The four corners of a box in world mm, counter-clockwise, beginning at its own lower left. */
export function boxOutline({ at, size, turn }: Box): Outline {
  const x = size[0] / 2;
  const y = size[1] / 2;
  const corners = [
    { x: -x, y: -y },
    { x, y: -y },
    { x, y },
    { x: -x, y },
  ];
  return movedOutline(corners, { x: at[0], y: at[1] }, directionOf(turn));
}

/** An outline turned about the origin so that +x points along `direction` (of length 1), then moved. */
export function movedOutline(outline: Outline, by: Vec, direction: Vec): Outline {
  const { x: cos, y: sin } = direction;
  return outline.map(({ x, y }) => ({ x: by.x + x * cos - y * sin, y: by.y + x * sin + y * cos }));
}

/** The ground that a mover passes over: the outlines at its start and at its turning point, and what lies between. */
export function trackOutline(mover: Mover): Outline {
  const start = boxOutline(mover);
  const end = boxOutline({ ...mover, at: mover.to });
  return convexHull([...start, ...end]);
}

/** Figures of a course are whole mm; so little is an error of rounding. */
const ROUNDING_MM = 1e-6;

/** Whether a place lies in a zone; its edge belongs to it. World mm. */
export function zoneHolds(zone: Zone, place: Vec): boolean {
  const { x, y } = toOwnFrame(zone, place);
  const halfX = zone.size[0] / 2 + ROUNDING_MM;
  const halfY = zone.size[1] / 2 + ROUNDING_MM;
  if (!zone.round) return Math.abs(x) <= halfX && Math.abs(y) <= halfY;
  const alongX = x / halfX;
  const alongY = y / halfY;
  return alongX * alongX + alongY * alongY <= 1;
}

/** Whether a convex outline in world mm covers a part of a zone; touching its edge is not yet covering. */
export function zoneOverlaps(zone: Zone, outline: Outline): boolean {
  if (!zone.round) return overlapMm(outline, boxOutline(zone)) > ROUNDING_MM;
  const scaleX = 2 / zone.size[0];
  const scaleY = 2 / zone.size[1];
  const inCircle = outline.map((corner) => {
    const { x, y } = toOwnFrame(zone, corner);
    return { x: x * scaleX, y: y * scaleY };
  });
  return coversUnitCircle(inCircle);
}

function toOwnFrame({ at, turn }: Box, place: Vec): Vec {
  const { x: cos, y: sin } = directionOf(turn);
  const x = place.x - at[0];
  const y = place.y - at[1];
  return { x: x * cos + y * sin, y: y * cos - x * sin };
}

/** Whether a convex outline covers a part of the circle of radius 1 about the origin. */
function coversUnitCircle(outline: Outline): boolean {
  let lefts = 0;
  let rights = 0;
  for (const [index, from] of outline.entries()) {
    const to = outline[(index + 1) % outline.length] ?? from;
    if (squaredDistance({ x: 0, y: 0 }, from, to) < 1 - ROUNDING_MM) return true;
    if (from.x * to.y - from.y * to.x > 0) lefts++;
    else rights++;
  }
  return lefts === 0 || rights === 0; // the origin lies on the same side of all edges: the circle lies inside
}

/** The square of the distance from a place to the line between two places. */
export function squaredDistance(place: Vec, from: Vec, to: Vec): number {
  const dx = to.x - from.x;
  const dy = to.y - from.y;
  const squaredLength = dx * dx + dy * dy;
  const along = squaredLength === 0 ? 0 : ((place.x - from.x) * dx + (place.y - from.y) * dy) / squaredLength;
  const share = Math.max(0, Math.min(1, along));
  const x = place.x - from.x - share * dx;
  const y = place.y - from.y - share * dy;
  return x * x + y * y;
}

/**
 * How deep two convex outlines overlap, in mm: so far one of them must move. 0 or less when some line parts them
 * (separating axis theorem); then at least so far they are apart.
 */
export function overlapMm(a: Outline, b: Outline): number {
  return Math.min(depthAlongAxesOf(a, a, b), depthAlongAxesOf(b, a, b));
}

function depthAlongAxesOf(outline: Outline, a: Outline, b: Outline): number {
  let depth = Infinity;
  for (const [index, corner] of outline.entries()) {
    const next = outline[(index + 1) % outline.length] ?? corner;
    const length = lengthOf(next.x - corner.x, next.y - corner.y);
    if (length === 0) continue;
    const axis = { x: (corner.y - next.y) / length, y: (next.x - corner.x) / length };
    const [minA, maxA] = extent(a, axis);
    const [minB, maxB] = extent(b, axis);
    depth = Math.min(depth, maxA - minB, maxB - minA);
  }
  return depth;
}

function extent(outline: Outline, axis: Vec): readonly [number, number] {
  let min = Infinity;
  let max = -Infinity;
  for (const { x, y } of outline) {
    const along = x * axis.x + y * axis.y;
    if (along < min) min = along;
    if (along > max) max = along;
  }
  return [min, max];
}

/** The smallest rectangle along the axes around an object, with the width of strokes and the track of movers. World mm. */
export function boundsOf(object: SceneObject): Bounds {
  switch (object.type) {
    case 'stroke':
      return strokeBounds(object);
    case 'target':
    case 'checkpoint':
    case 'forbidden':
      return object.round ? ellipseBounds(object) : boundsOfOutline(boxOutline(object));
    case 'label':
      return boundsOfOutline(labelOutline(object));
    case 'mover':
      return boundsOfOutline(trackOutline(object));
    case 'wall':
      return boundsOfOutline(wallOutline(object));
    case 'block':
    case 'fixed-block':
    case 'spikes':
      return boundsOfOutline(boxOutline(object));
    default:
      return object satisfies never;
  }
}

/** The smallest rectangle along the axes around some places. */
export function boundsOfOutline(outline: Outline): Bounds {
  const bounds = { minX: Infinity, minY: Infinity, maxX: -Infinity, maxY: -Infinity };
  for (const { x, y } of outline) {
    if (x < bounds.minX) bounds.minX = x;
    if (x > bounds.maxX) bounds.maxX = x;
    if (y < bounds.minY) bounds.minY = y;
    if (y > bounds.maxY) bounds.maxY = y;
  }
  return bounds;
}

/** Whether two rectangles have a place in common. */
export const boundsMeet = (a: Bounds, b: Bounds): boolean =>
  a.minX <= b.maxX && b.minX <= a.maxX && a.minY <= b.maxY && b.minY <= a.maxY;

const boundsOfStrokes = new WeakMap<Stroke, Bounds>();

/** Kept for each stroke, which never changes: it may have tens of thousands of points. */
function strokeBounds(stroke: Stroke): Bounds {
  const known = boundsOfStrokes.get(stroke);
  if (known) return known;
  const half = stroke.width / 2;
  const line = boundsOfOutline(stroke.points.map(([x, y]) => ({ x, y })));
  const bounds = { minX: line.minX - half, minY: line.minY - half, maxX: line.maxX + half, maxY: line.maxY + half };
  boundsOfStrokes.set(stroke, bounds);
  return bounds;
}

function ellipseBounds({ at: [x, y], size, turn }: Box): Bounds {
  const { x: cos, y: sin } = directionOf(turn);
  const [halfX, halfY] = [size[0] / 2, size[1] / 2];
  const reachX = lengthOf(halfX * cos, halfY * sin);
  const reachY = lengthOf(halfX * sin, halfY * cos);
  return { minX: x - reachX, minY: y - reachY, maxX: x + reachX, maxY: y + reachY };
}

// chosen: a bold sans serif letter is 0.8 of a capital's height wide on average; capitals are 0.72 of the line
const LETTER_WIDTH = 0.8;
const LINE_HEIGHT = 1.4;

/** The box a label is taken to fill; how wide its letters really are differs between screens. */
export function labelOutline({ at, text, height, turn }: Label): Outline {
  return boxOutline({ at, size: [text.length * height * LETTER_WIDTH, height * LINE_HEIGHT], turn });
}

/** The arena as an outline: a rectangle from the origin. */
export const arenaOutline = ([width, height]: Point): Outline => [
  { x: 0, y: 0 },
  { x: width, y: 0 },
  { x: width, y: height },
  { x: 0, y: height },
];

/** Whether a part of an object lies in an arena of this size; for the round ends of strokes this errs towards yes. */
export function reachesInto(object: SceneObject, size: Point): boolean {
  const arena = arenaOutline(size);
  switch (object.type) {
    case 'stroke':
      return strokeReachesInto(object, arena);
    case 'target':
    case 'checkpoint':
    case 'forbidden':
      return zoneOverlaps(object, arena);
    case 'label':
      return overlapMm(labelOutline(object), arena) > 0;
    case 'mover':
      return overlapMm(trackOutline(object), arena) > 0;
    case 'wall':
      return overlapMm(wallOutline(object), arena) > 0;
    case 'block':
    case 'fixed-block':
    case 'spikes':
      return overlapMm(boxOutline(object), arena) > 0;
    default:
      return object satisfies never;
  }
}

function strokeReachesInto(stroke: Stroke, arena: Outline): boolean {
  if (!boundsMeet(strokeBounds(stroke), boundsOfOutline(arena))) return false;
  return stroke.points.some(([x, y], index) => {
    const [fromX, fromY] = stroke.points[index - 1] ?? [x, y];
    const piece = [
      { x: fromX, y: fromY },
      { x, y },
    ];
    return overlapMm(piece, arena) > -stroke.width / 2;
  });
}

/** The convex outline around some places, counter-clockwise (Andrew's monotone chain). */
export function convexHull(places: readonly Vec[]): Outline {
  const sorted = [...places].sort((a, b) => a.x - b.x || a.y - b.y);
  const lower = halfHull(sorted);
  const upper = halfHull(sorted.reverse());
  return [...lower.slice(0, -1), ...upper.slice(0, -1)];
}

function halfHull(sorted: readonly Vec[]): readonly Vec[] {
  const hull: Vec[] = [];
  for (const place of sorted) {
    while (hull.length > 1 && !turnsLeft(hull[hull.length - 2], hull[hull.length - 1], place)) hull.pop();
    hull.push(place);
  }
  return hull;
}

function turnsLeft(one: Vec | undefined, two: Vec | undefined, three: Vec): boolean {
  if (!one || !two) return true;
  return (two.x - one.x) * (three.y - one.y) - (two.y - one.y) * (three.x - one.x) > 0;
}

/** The length of a displacement, in mm. */
export const lengthOf = (x: number, y: number): number => Math.sqrt(x * x + y * y);
