import { exactAtan2, exactCos, exactSin } from '#core/exact-math';
import type { Vec } from '#core/geometry';
import { createRng, type Rng } from '#core/rng';
import { sceneDefaults, type Point, type Scene, type SceneObject } from '../scene';

/** The request for a random line track. */
export interface TrackWish {
  /** A whole number; the same seed, bends and size always give the same track. */
  readonly seed: number;
  /** How many bends it shall have at least, where the arena has room for them: `trackLimits.bends`. */
  readonly bends: number;
  /** The arena in mm: `trackLimits.sizeMm`. */
  readonly size: Point;
}

/** Limits of tracks, and what every track guarantees. */
export const trackLimits = {
  bends: { min: 4, max: 14 },
  sizeMm: { min: 900, max: 4000 },
  /** The least radius of a bend. Chosen: followed at half speed by robots with two line sensors. */
  radiusMm: 120,
  /** From one part of the line to another, edge to edge: no sensor sees both. */
  gapMm: 60,
  /** From the edge of the arena to the middle of the line. Chosen: robots turn on the line without a touch. */
  marginMm: 110,
} as const;

const WIDTH = sceneDefaults.width;
const TRIES = 60; // chosen: tries beyond are so near to the grid that they look like it
const CELL_MM = 250; // chosen: a bend of 120 mm takes nearly half a side, the next one the other half
const SAG_MM = 0.25; // chosen: an arc may be this far from its chord; points are rounded to whole mm anyway
const TWO_PI = 6.283185307179586;
const MARK_MM = 150; // chosen: a robot on the line cannot pass beside a checkpoint

/**
 * A closed line without corners and crossings as a course: the robot stands on it, passes three checkpoints on its lap,
 * and comes back to its start.
 *
 * @param words name and description of the course
 * @throws RangeError for requests beyond `trackLimits`
 */
export function randomTrack(wish: TrackWish, words: Pick<Scene, 'name' | 'description'>): Scene {
  checkWish(wish);
  const rng = createRng(wish.seed).fork('track');
  const loop = findLoop(wish, rng);
  const start = longestPiece(loop);
  const ring = [...loop.slice(start + 1), ...loop.slice(0, start + 1)];
  const [before, after] = [loop[start] ?? ORIGIN, ring[0] ?? ORIGIN];
  const at: Vec = { x: (before.x + after.x) / 2, y: (before.y + after.y) / 2 };
  const headingDeg = Math.round((exactAtan2(after.y - before.y, after.x - before.x) * 360) / TWO_PI) + 0; // never −0
  const points = [...ring, after].map(rounded);
  return {
    ...words,
    size: wish.size,
    board: null,
    robot: { type: null, at: rounded(at), heading: headingDeg, scale: 1, options: {} },
    task: sceneDefaults.task,
    background: null,
    objects: [{ type: 'stroke', id: 'line', points, width: WIDTH, color: 'black' }, ...marks(at, ring)],
  };
}

const ORIGIN: Vec = { x: 0, y: 0 };

function checkWish({ bends, size }: TrackWish): void {
  const { bends: count, sizeMm } = trackLimits;
  if (!Number.isInteger(bends) || bends < count.min || bends > count.max)
    throw new RangeError(`A track has ${String(count.min)} to ${String(count.max)} bends, not ${String(bends)}.`);
  if (size.some((side) => !Number.isInteger(side) || side < sizeMm.min || side > sizeMm.max))
    throw new RangeError(`A track needs an arena of ${String(sizeMm.min)} to ${String(sizeMm.max)} mm a side, not ${size.join(' × ')}.`); // prettier-ignore
}

/**
 * Goes round a random patch of squares, its corners moved at random: less and less until the line through them keeps what
 * is promised. On the grid itself it always does.
 */
function findLoop(wish: TrackWish, rng: Rng): readonly Vec[] {
  const grid = gridOf(wish.size);
  const polygon = outlineOf(grow(wish.bends, grid, rng));
  for (let attempt = 0; attempt < TRIES; attempt += 1) {
    const loop = rounding(place(polygon, grid, rng, 0.45 * (1 - attempt / TRIES)));
    if (loop !== null && isClear(loop, wish.size)) return loop;
  }
  return rounding(place(polygon, grid, rng, 0)) ?? [];
}

/** The squares that the line may go round. */
interface Grid {
  readonly columns: number;
  readonly rows: number;
  /** Sides of a square. */
  readonly cellMm: Vec;
}

function gridOf(size: Point): Grid {
  const [width, height] = size.map((side) => side - 2 * trackLimits.marginMm);
  const count = (side = 0): number => Math.max(2, Math.floor(side / CELL_MM));
  const [columns, rows] = [count(width), count(height)];
  return { columns, rows, cellMm: { x: (width ?? 0) / columns, y: (height ?? 0) / rows } };
}

const key = (x: number, y: number): string => `${String(x)},${String(y)}`;

/**
 * A patch of squares without holes, grown square by square. Of all patches on the way that cover half of the grid or
 * more, the first whose outline has at least this many corners is taken, or else the one with the most.
 */
function grow(bends: number, { columns, rows }: Grid, rng: Rng): ReadonlySet<string> {
  const any = (count: number): number => Math.floor(rng.unit() * count);
  const patch = new Set([key(any(columns), any(rows))]);
  let best: ReadonlySet<string> = patch;
  let off = Infinity;
  for (let attempt = 0; attempt < 40 * columns * rows && off > 0; attempt += 1) {
    const [x, y] = [any(columns), any(rows)];
    if (!isGrowth(patch, x, y)) continue;
    patch.add(key(x, y));
    if (patch.size < (columns * rows) / 2) continue;
    const corners = outlineOf(patch).length;
    const isOff = corners === 4 ? Infinity : Math.max(0, bends - corners); // with four corners nothing bends both ways
    if (isOff >= off) continue;
    best = new Set(patch);
    off = isOff;
  }
  return best;
}

const AROUND = [
  [1, 0],
  [1, 1],
  [0, 1],
  [-1, 1],
  [-1, 0],
  [-1, -1],
  [0, -1],
  [1, -1],
] as const;

/** True for a free square that touches the patch in one stretch of its rim, by one or two sides: no hole, no pinch. */
function isGrowth(patch: ReadonlySet<string>, x: number, y: number): boolean {
  if (patch.has(key(x, y))) return false;
  const around = AROUND.map(([dx, dy]) => patch.has(key(x + dx, y + dy)));
  const stretches = around.filter((isIn, index) => isIn && around.at(index - 1) === false).length;
  const touchesBySide = around.some((isIn, index) => isIn && index % 2 === 0);
  // A patch that only fills up would end as the whole grid: some squares stay free at the third side.
  const sides = around.filter((isIn, index) => isIn && index % 2 === 0).length;
  return touchesBySide && stretches === 1 && sides < 3;
}

/** The corners of the patch's outline, counter-clockwise, in squares. */
function outlineOf(patch: ReadonlySet<string>): readonly Vec[] {
  const next = new Map<string, Vec>();
  for (const cell of patch) {
    const [x = 0, y = 0] = cell.split(',').map(Number);
    if (!patch.has(key(x, y - 1))) next.set(key(x, y), { x: x + 1, y });
    if (!patch.has(key(x + 1, y))) next.set(key(x + 1, y), { x: x + 1, y: y + 1 });
    if (!patch.has(key(x, y + 1))) next.set(key(x + 1, y + 1), { x, y: y + 1 });
    if (!patch.has(key(x - 1, y))) next.set(key(x, y + 1), { x, y });
  }
  const [first] = next.values();
  const loop: Vec[] = [];
  for (let at = first; at !== undefined && loop.length < next.size; at = next.get(key(at.x, at.y))) loop.push(at);
  return loop.filter((at, index) => {
    const before = loop.at(index - 1) ?? at;
    const after = loop[(index + 1) % loop.length] ?? at;
    return (at.x - before.x) * (after.y - at.y) !== (at.y - before.y) * (after.x - at.x);
  });
}

/** The corners in the arena, each moved by up to `share` of a square; none beyond the margin. */
function place(polygon: readonly Vec[], { columns, rows, cellMm }: Grid, rng: Rng, share: number): readonly Vec[] {
  const moved = (at: number, count: number): number => {
    const to = at + share * (2 * rng.unit() - 1);
    return Math.min(count, Math.max(0, to));
  };
  return polygon.map(({ x, y }) => ({
    x: trackLimits.marginMm + moved(x, columns) * cellMm.x,
    y: trackLimits.marginMm + moved(y, rows) * cellMm.y,
  }));
}

/**
 * The corners rounded by arcs, each as wide as its two sides allow; `null` where one would be tighter than promised.
 * An arc of radius r at a corner that turns by φ begins r · tan(φ/2) before it.
 */
function rounding(polygon: readonly Vec[]): readonly Vec[] | null {
  const loop: Vec[] = [];
  for (const [index, corner] of polygon.entries()) {
    const before = polygon.at(index - 1) ?? corner;
    const after = polygon[(index + 1) % polygon.length] ?? corner;
    const arc = arcAt(before, corner, after);
    if (arc === null) return null;
    loop.push(...arc);
  }
  return loop;
}

function arcAt(before: Vec, corner: Vec, after: Vec): Vec[] | null {
  const [inward, outward] = [between(before, corner), between(corner, after)];
  const cross = inward.x * outward.y - inward.y * outward.x;
  const dot = inward.x * outward.x + inward.y * outward.y;
  const tangent = Math.abs(cross) / (1 + dot); // tan(φ/2)
  const room = 0.49 * Math.min(distance(before, corner), distance(corner, after)); // a bit of straight line is left
  const radius = Math.min(room / Math.max(tangent, 1e-9), 400);
  if (!(radius >= trackLimits.radiusMm + 1)) return null; // 1: for rounding to whole mm
  const reach = radius * tangent;
  const side = cross > 0 ? 1 : -1;
  const start = { x: corner.x - reach * inward.x, y: corner.y - reach * inward.y };
  const centre = { x: start.x - side * radius * inward.y, y: start.y + side * radius * inward.x };
  const turn = exactAtan2(Math.abs(cross), dot);
  // A chord over the angle a is r (1 − cos(a/2)) ≈ r a²/8 from its arc.
  const steps = Math.max(1, Math.ceil(turn / Math.sqrt((8 * SAG_MM) / radius)));
  return Array.from({ length: steps + 1 }, (_, step) => {
    const angle = (side * turn * step) / steps;
    const [cos, sin] = [exactCos(angle), exactSin(angle)];
    const from = { x: start.x - centre.x, y: start.y - centre.y };
    return { x: centre.x + cos * from.x - sin * from.y, y: centre.y + sin * from.x + cos * from.y };
  });
}

function between(from: Vec, to: Vec): Vec {
  const length = distance(from, to);
  return { x: (to.x - from.x) / length, y: (to.y - from.y) / length };
}

function distance(one: Vec, other: Vec): number {
  const [dx, dy] = [one.x - other.x, one.y - other.y];
  return Math.sqrt(dx * dx + dy * dy);
}

/** The line keeps to its margin, and no part of it comes near another that is not its neighbour. */
function isClear(loop: readonly Vec[], size: Point): boolean {
  const margin = trackLimits.marginMm - 1; // for what the sines leave behind
  if (loop.some(({ x, y }) => x < margin || y < margin || x > size[0] - margin || y > size[1] - margin)) return false;
  const even = evenly(loop, 25); // chosen: two parts are then measured to within a few mm
  const near = trackLimits.gapMm + WIDTH + 10;
  // Along the tightest half circle that is allowed, the line comes no nearer to itself than its diameter.
  const apart = Math.ceil((3.2 * trackLimits.radiusMm) / 25);
  for (let i = 0; i < even.length; i += 1)
    for (let j = i + apart; j < even.length && j <= i + even.length - apart; j += 1)
      if (distance(even[i] ?? ORIGIN, even[j] ?? ORIGIN) < near) return false;
  return true;
}

/** Points along the closed line, about `everyMm` apart. */
function evenly(loop: readonly Vec[], everyMm: number): Vec[] {
  return loop.flatMap((from, index) => {
    const to = loop[(index + 1) % loop.length] ?? from;
    const pieces = Math.max(1, Math.round(distance(from, to) / everyMm));
    return Array.from({ length: pieces }, (_, piece) => {
      const share = piece / pieces;
      return { x: from.x + share * (to.x - from.x), y: from.y + share * (to.y - from.y) };
    });
  });
}

/** The index of the point where the longest straight piece begins. */
function longestPiece(loop: readonly Vec[]): number {
  const lengths = loop.map((point, index) => distance(point, loop[(index + 1) % loop.length] ?? point));
  return lengths.indexOf(Math.max(...lengths));
}

/** Three checkpoints at the quarters of the lap, and the target where the robot starts. */
function marks(start: Vec, ring: readonly Vec[]): SceneObject[] {
  const way = evenly(ring, 10);
  const quarter = (part: number): Point => rounded(way[Math.floor((way.length * part) / 4)] ?? ORIGIN);
  const zone = { size: [MARK_MM, MARK_MM], angle: 0, round: true, blocks: 0 } as const;
  return [
    ...[1, 2, 3].map((number): SceneObject => {
      return { ...zone, type: 'checkpoint', id: `checkpoint-${String(number)}`, at: quarter(number), number };
    }),
    { ...zone, type: 'target', id: 'target', at: rounded(start), number: 0 },
  ];
}

const rounded = ({ x, y }: Vec): Point => [Math.round(x), Math.round(y)];
