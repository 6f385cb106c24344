import { rotationRad } from '#core/angle';
import { exactCos, exactSin } from '#core/exact-math';
import type { Vec } from '#core/geometry';
import type { Point } from './scene';

/** The corners of an outline in mm, in order, either way round. Convex unless said otherwise. */
export type Outline = readonly Vec[];

/** A rectangle along the axes, in mm. */
export interface Bounds {
  readonly minX: number;
  readonly minY: number;
  readonly maxX: number;
  readonly maxY: number;
}

/** A turned rectangle: centre, extent along its own x and y, and rotation in degrees. */
export interface Box {
  readonly at: Point;
  readonly size: Point;
  readonly angle: number;
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
export function directionOf(angleDeg: number): Vec {
  const eighths = angleDeg / 45;
  if (Number.isInteger(eighths)) return EIGHTHS[eighths & 7] ?? AHEAD;
  const rad = rotationRad(angleDeg);
  return { x: exactCos(rad), y: exactSin(rad) };
}

/** The four corners of a box in world mm, counter-clockwise, beginning at its own lower left. */
export function boxOutline({ at, size, angle }: Box): Outline {
  const x = size[0] / 2;
  const y = size[1] / 2;
  const corners = [
    { x: -x, y: -y },
    { x, y: -y },
    { x, y },
    { x: -x, y },
  ];
  return movedOutline(corners, { x: at[0], y: at[1] }, directionOf(angle));
}

/** An outline turned about the origin so that +x points along `direction` (of length 1), then moved. */
export function movedOutline(outline: Outline, by: Vec, direction: Vec): Outline {
  const { x: cos, y: sin } = direction;
  return outline.map(({ x, y }) => ({ x: by.x + x * cos - y * sin, y: by.y + x * sin + y * cos }));
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

/** Distance of a place from the edge of an outline in mm. */
export function distanceToEdge(outline: Outline, place: Vec): number {
  let squared = Infinity;
  let from = outline[outline.length - 1];
  for (const to of outline) {
    squared = Math.min(squared, squaredDistance(place, from ?? to, to));
    from = to;
  }
  return Math.sqrt(squared);
}

/** Distance of a place from a convex outline in mm; 0 inside. */
export function distanceToOutline(outline: Outline, place: Vec): number {
  let squared = Infinity;
  let lefts = 0;
  let rights = 0;
  outline.forEach((from, index) => {
    const to = outline[(index + 1) % outline.length] ?? from;
    squared = Math.min(squared, squaredDistance(place, from, to));
    const side = (to.x - from.x) * (place.y - from.y) - (to.y - from.y) * (place.x - from.x);
    if (side > 0) lefts += 1;
    if (side < 0) rights += 1;
  });
  return outline.length > 2 && (lefts === 0 || rights === 0) ? 0 : Math.sqrt(squared);
}

/**
 * Overlap of two convex outlines in mm: the distance that one of them must move. 0 or less if a line separates them
 * (separating axis theorem); they are then at least that far apart.
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

/** True if two rectangles have a place in common. */
export const boundsMeet = (a: Bounds, b: Bounds): boolean =>
  a.minX <= b.maxX && b.minX <= a.maxX && a.minY <= b.maxY && b.minY <= a.maxY;

/** The arena as an outline: a rectangle from the origin. */
export const arenaOutline = ([width, height]: Point): Outline => [
  { x: 0, y: 0 },
  { x: width, y: 0 },
  { x: width, y: height },
  { x: 0, y: height },
];

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
