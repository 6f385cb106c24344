import { solidParts } from './kinds/index';
import { boundsOfOutline, overlapMm, type Bounds, type Outline } from './outline';
import type { Block, Point, SceneObject } from './scene';

/** Bodies may overlap by this much: the numbers of a course are whole mm, and turned corners are not. */
const TOLERANCE_MM = 1;

/** Maximum number of pairs that are measured. Chosen: a few 10 ms; more pairs means hundreds of things in one heap. */
const MOST_PAIRS = 50_000;

interface Solid {
  readonly object: SceneObject;
  /** Convex parts. */
  readonly parts: readonly Outline[];
  readonly bounds: Bounds;
}

/** A movable block and what it overlaps. */
export interface Stuck {
  readonly block: Block;
  readonly other: SceneObject;
}

/** Movable blocks that overlap something solid, each once: their run would begin with a jolt. */
export function stuckBlocks(objects: readonly SceneObject[]): readonly Stuck[] {
  const solids = solidsOf(objects);
  const stuck = new Map<Block, SceneObject>();
  let pairs = 0;
  for (const [index, one] of solids.entries()) {
    for (let next = index + 1; next < solids.length && pairs < MOST_PAIRS; next++) {
      const other = solids[next];
      if (!other || other.bounds.minX > one.bounds.maxX) break;
      const pair = movableFirst(one, other);
      if (!pair || stuck.has(pair.block) || !sharesHeight(one.bounds, other.bounds)) continue;
      pairs++;
      if (areInside(one, other)) stuck.set(pair.block, pair.other);
    }
  }
  return [...stuck].map(([block, other]) => ({ block, other }));
}

const areInside = ({ parts }: Solid, other: Solid): boolean =>
  parts.some((one) => other.parts.some((another) => overlapMm(one, another) > TOLERANCE_MM));

/** Everything solid, from left to right. */
function solidsOf(objects: readonly SceneObject[]): readonly Solid[] {
  const solids = objects.flatMap((object): Solid[] => {
    const parts = solidParts(object);
    return parts.length > 0 ? [{ object, parts, bounds: boundsOfOutline(parts.flat()) }] : [];
  });
  return solids.sort((one, other) => one.bounds.minX - other.bounds.minX);
}

/**
 * Maximum number of overlapping pairs with which a run begins. Chosen: 63 blocks at one place; the physics looks at
 * every pair in every step, and 300 blocks at one place (45,000 pairs) take seconds a step and hundreds of MB.
 */
export const MOST_STUCK_PAIRS = 2000;

/** True if movable blocks overlap each other or other solid things in more than `MOST_STUCK_PAIRS` pairs. */
export function isHeap(objects: readonly SceneObject[]): boolean {
  const solids = solidsOf(objects);
  let [measured, overlapping] = [0, 0];
  for (const [index, one] of solids.entries()) {
    for (let next = index + 1; next < solids.length && measured < MOST_PAIRS; next++) {
      const other = solids[next];
      if (!other || other.bounds.minX > one.bounds.maxX) break;
      if (!movableFirst(one, other) || !sharesHeight(one.bounds, other.bounds)) continue;
      measured++;
      if (areInside(one, other)) overlapping++;
      if (overlapping > MOST_STUCK_PAIRS) return true;
    }
  }
  return false;
}

function movableFirst({ object: one }: Solid, { object: other }: Solid): Stuck | null {
  if (one.type === 'block') return { block: one, other };
  return other.type === 'block' ? { block: other, other: one } : null;
}

const sharesHeight = (one: Bounds, other: Bounds): boolean => one.minY <= other.maxY && other.minY <= one.maxY;

/** Groups of objects that are the same in all but their id, so that only the topmost is ever seen. */
export function identicalGroups(objects: readonly SceneObject[]): readonly (readonly SceneObject[])[] {
  const groups = new Map<string, SceneObject[]>();
  for (const object of objects) {
    const look = lookOf(object);
    const group = groups.get(look);
    if (group) group.push(object);
    else groups.set(look, [object]);
  }
  return [...groups.values()].filter((group) => group.length > 1);
}

/** Everything of an object but its id, as text. Of a line's points only a sum: there may be tens of thousands. */
function lookOf(object: SceneObject): string {
  const parts = { ...object, id: '', ...(object.type === 'stroke' ? { points: checksum(object.points) } : {}) };
  return JSON.stringify(Object.entries(parts).sort(([one], [other]) => (one < other ? -1 : 1)));
}

/** FNV-1a with 32 bits, twice: once from either end of each point. */
function checksum(points: readonly Point[]): string {
  let one = 0x811c9dc5;
  let other = 0x811c9dc5;
  for (const [x, y] of points) {
    one = Math.imul(Math.imul(one ^ x, 0x01000193) ^ y, 0x01000193);
    other = Math.imul(Math.imul(other ^ y, 0x01000193) ^ x, 0x01000193);
  }
  return `${points.length}/${one}/${other}`;
}
