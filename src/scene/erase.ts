import type { Vec } from '#core/geometry';
import { isSame } from '#core/same';
import { boundsOf } from './kinds/index';
import { boundsMeet, boundsOfOutline, lengthOf, type Bounds } from './outline';
import type { Point, Stroke } from './scene';
import { thinned } from './simplify';

/** A round eraser and its path. */
export interface Eraser {
  readonly radiusMm: number;
  /** The path, piece by piece. */
  readonly pieces: readonly Piece[];
  /** Rectangles around each piece, then around every eight of these, up to a single one: far pieces are skipped. */
  readonly levels: readonly (readonly Bounds[])[];
}

/** A straight piece of the path; a single place if both ends are equal. */
interface Piece {
  readonly from: Vec;
  readonly to: Vec;
}

/** A part of a straight line, between two shares of its length: the whole line is 0 … 1. */
type Interval = readonly [from: number, to: number];

const FAN = 8; // chosen: flat enough to be built on every move of the pointer
const PATH_TOLERANCE_MM = 0.25; // chosen: it is invisible, and a slow hand costs no more than a fast one

/** An eraser that went along a path in world mm; a single place is a dab. */
export function eraserAlong(path: readonly Vec[], radiusMm: number): Eraser {
  const places = thinned(path, PATH_TOLERANCE_MM);
  const [first] = places;
  const ends = places.length === 1 && first ? [first, first] : places;
  const pieces = ends.slice(1).map((to, index) => ({ from: ends[index] ?? to, to }));
  const levels: (readonly Bounds[])[] = [pieces.map(({ from, to }) => boundsOfOutline([from, to]))];
  for (let level = levels[0] ?? []; level.length > 1; levels.push(level)) level = grouped(level);
  return { radiusMm, pieces, levels };
}

function grouped(level: readonly Bounds[]): readonly Bounds[] {
  const groups: Bounds[] = [];
  for (let at = 0; at < level.length; at += FAN) groups.push(unionOf(level.slice(at, at + FAN)));
  return groups;
}

function unionOf(all: readonly Bounds[]): Bounds {
  return boundsOfOutline(
    all.flatMap(({ minX, minY, maxX, maxY }) => [
      { x: minX, y: minY },
      { x: maxX, y: maxY },
    ]),
  );
}

/**
 * The rest of a stroke after an eraser. No paint stays under the eraser, however fast it went: the middle line is cut
 * where the eraser comes nearer than half the stroke's width, because the ends of the rest are round.
 *
 * @returns the remaining lines, in their order, none shorter than 1 mm; `null` if the stroke stays as it is
 */
export function erased(stroke: Stroke, eraser: Eraser): readonly (readonly Point[])[] | null {
  const reachMm = eraser.radiusMm + stroke.width / 2;
  if (!mayTouch(stroke, eraser)) return null;
  const [first] = stroke.points;
  if (!first || stroke.points.every((point) => isSame(point, first)))
    return first && erasedParts(vecOf(first), vecOf(first), eraser, reachMm).length > 0 ? [] : null;
  const left = new Remains();
  for (const [index, point] of stroke.points.entries()) {
    const before = stroke.points[index - 1];
    if (!before || isSame(before, point)) continue;
    left.addLine(before, point, erasedParts(vecOf(before), vecOf(point), eraser, reachMm));
  }
  const lines = left.isCut ? left.lines() : [stroke.points];
  return lines.length === 1 && lines[0] && isSame(lines[0], stroke.points) ? null : lines;
}

function mayTouch(stroke: Stroke, { levels, radiusMm }: Eraser): boolean {
  const around = levels.at(-1)?.[0];
  return around !== undefined && boundsMeet(boundsOf(stroke), grown(around, radiusMm));
}

const grown = ({ minX, minY, maxX, maxY }: Bounds, by: number): Bounds => ({
  minX: minX - by,
  minY: minY - by,
  maxX: maxX + by,
  maxY: maxY + by,
});

/** Collects what is left of a polyline, walked from its first point to its last. */
class Remains {
  isCut = false;
  private readonly done: Point[][] = [];
  private current: Point[] | null = null;

  /** Adds the next straight line of the polyline; `parts` of it are erased, in order. */
  addLine(from: Point, to: Point, parts: readonly Interval[]): void {
    if (this.current === null && (parts[0]?.[0] ?? 1) > 0) this.current = [from];
    for (const [start, end] of parts) {
      this.isCut = true;
      this.finish(between(from, to, start));
      if (end < 1) this.current = [between(from, to, end)];
    }
    if (this.current) add(this.current, to);
  }

  /** All lines that are left. */
  lines(): readonly (readonly Point[])[] {
    this.finish(null);
    return this.done;
  }

  private finish(end: Point | null): void {
    if (!this.current) return;
    if (end) add(this.current, end);
    if (this.current.length > 1) this.done.push(this.current);
    this.current = null;
  }
}

function add(line: Point[], point: Point): void {
  const last = line[line.length - 1];
  if (!last || !isSame(last, point)) line.push(point);
}

const vecOf = ([x, y]: Point): Vec => ({ x, y });
const between = (from: Point, to: Point, share: number): Point => [
  Math.round(from[0] + (to[0] - from[0]) * share) + 0,
  Math.round(from[1] + (to[1] - from[1]) * share) + 0,
];

/** The parts of a straight line within reach of the eraser: in order, none touching another. */
function erasedParts(from: Vec, to: Vec, eraser: Eraser, reachMm: number): readonly Interval[] {
  const around = grown(boundsOfOutline([from, to]), reachMm);
  const found: Interval[] = [];
  let isWhole = false;
  const look = (depth: number, at: number): void => {
    const bounds = eraser.levels[depth]?.[at];
    if (isWhole || !bounds || !boundsMeet(bounds, around)) return;
    if (depth > 0) {
      for (let child = at * FAN; child < (at + 1) * FAN; child++) look(depth - 1, child);
      return;
    }
    const piece = eraser.pieces[at];
    const part = piece && partNear(from, to, piece, reachMm);
    if (!part) return;
    found.push(part);
    isWhole = part[0] === 0 && part[1] === 1;
  };
  look(eraser.levels.length - 1, 0);
  return merged(found);
}

function merged(intervals: readonly Interval[]): readonly Interval[] {
  const all: [number, number][] = [];
  for (const [from, to] of [...intervals].sort((a, b) => a[0] - b[0])) {
    const last = all[all.length - 1];
    if (last && from <= last[1]) last[1] = Math.max(last[1], to);
    else all.push([from, to]);
  }
  return all;
}

/** The part of a straight line that is nearer than `reachMm` to a piece of the path; a mere touch does not count. */
function partNear(from: Vec, to: Vec, piece: Piece, reachMm: number): Interval | null {
  const direction = { x: to.x - from.x, y: to.y - from.y };
  const parts = [
    partInDisc(from, direction, piece.from, reachMm),
    partInDisc(from, direction, piece.to, reachMm),
    partInStrip(from, direction, piece, reachMm),
  ].filter((part) => part !== null);
  // Discs and strip together are convex: what a straight line has in them is in one part.
  const start = Math.max(0, Math.min(...parts.map(([first]) => first)));
  const end = Math.min(1, Math.max(...parts.map(([, last]) => last)));
  return end - start > NOTHING || (start === 0 && end === 1) ? [start, end] : null;
}

const NOTHING = 1e-9;

function partInDisc(from: Vec, direction: Vec, centre: Vec, radiusMm: number): Interval | null {
  const x = from.x - centre.x;
  const y = from.y - centre.y;
  const outside = x * x + y * y - radiusMm * radiusMm;
  const squaredLength = direction.x * direction.x + direction.y * direction.y;
  if (squaredLength === 0) return outside < 0 ? [0, 1] : null;
  const half = (x * direction.x + y * direction.y) / squaredLength;
  const root = half * half - outside / squaredLength;
  if (root <= 0) return null;
  const width = Math.sqrt(root);
  return [-half - width, -half + width];
}

/** The part in the rectangle around a piece of the path, without its round ends. */
function partInStrip(from: Vec, direction: Vec, { from: start, to: end }: Piece, reachMm: number): Interval | null {
  const length = lengthOf(end.x - start.x, end.y - start.y);
  if (length === 0) return null;
  const along = { x: (end.x - start.x) / length, y: (end.y - start.y) / length };
  const x = from.x - start.x;
  const y = from.y - start.y;
  const lengthwise = partWithin(x * along.x + y * along.y, direction.x * along.x + direction.y * along.y, 0, length);
  const across = partWithin(
    y * along.x - x * along.y,
    direction.y * along.x - direction.x * along.y,
    -reachMm,
    reachMm,
  );
  if (!lengthwise || !across) return null;
  const first = Math.max(lengthwise[0], across[0]);
  const last = Math.min(lengthwise[1], across[1]);
  return first < last ? [first, last] : null;
}

/** The shares for which `value + share · change` lies between two bounds. */
function partWithin(value: number, change: number, min: number, max: number): Interval | null {
  if (change === 0) return value > min && value < max ? [-Infinity, Infinity] : null;
  const one = (min - value) / change;
  const other = (max - value) / change;
  return one < other ? [one, other] : [other, one];
}
