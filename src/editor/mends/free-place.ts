import { solidParts } from '#scene/kinds/index';
import { boundsMeet, boundsOfOutline, overlapMm, type Bounds, type Outline } from '#scene/outline';
import type { Point, Scene } from '#scene/scene';
import { arenaBounds, boundsAll } from '../bounds';

/** Distance of the places that are tried, in mm. */
const STEP_MM = 10;
/** Bodies may touch, and rounded corners overlap by this much, in mm. */
const TOLERANCE_MM = 0.5;

/**
 * How far something must be moved, in whole mm, to stand wholly in the arena and in nothing else: the least of what is
 * found on a grid around where it is. `null`: there is no room for it.
 *
 * @param parts what it consists of, convex, in world mm
 * @param others what it must keep clear of
 */
export function wayToRoom(parts: readonly Outline[], others: readonly Outline[], arena: Point): Point | null {
  const around = boundsAll(parts.map(boundsOfOutline));
  const home = around && wayInside(around, arena);
  if (around === null || home === null) return null;
  const taken = others.map((outline) => ({ outline, bounds: boundsOfOutline(outline) }));
  const isFree = ([dx, dy]: Point): boolean => {
    const there = shifted(around, dx, dy);
    if (!isInside(there, arena)) return false;
    const near = taken.filter(({ bounds }) => boundsMeet(bounds, there));
    if (near.length === 0) return true;
    const moved = parts.map((part) => part.map(({ x, y }) => ({ x: x + dx, y: y + dy })));
    return !near.some(({ outline }) => moved.some((part) => overlapMm(part, outline) > TOLERANCE_MM));
  };
  const rings = Math.ceil(Math.max(arena[0], arena[1]) / STEP_MM);
  for (let ring = 0; ring <= rings; ring += 1) {
    const found = nearest(ringAround(home, ring).filter(isFree));
    if (found !== null) return found;
  }
  return null;
}

/** The least way of a rectangle into the arena, in whole mm; `null`: it is larger than the arena. */
export function wayInside({ minX, minY, maxX, maxY }: Bounds, [width, height]: Point): Point | null {
  const along = (min: number, max: number, length: number): number | null => {
    const [least, most] = [Math.ceil(-min - ROUNDING_MM), Math.floor(length - max + ROUNDING_MM)];
    return least > most ? null : Math.min(most, Math.max(least, 0)) + 0;
  };
  const [dx, dy] = [along(minX, maxX, width), along(minY, maxY, height)];
  return dx === null || dy === null ? null : [dx, dy];
}

/** Rounding errors of a rotation are smaller than this. */
const ROUNDING_MM = 1e-6;

/** The ways of a square ring on the grid around one. */
function ringAround([x, y]: Point, ring: number): readonly Point[] {
  if (ring === 0) return [[x, y]];
  const ways: Point[] = [];
  for (let step = -ring; step <= ring; step += 1)
    for (const side of [-ring, ring]) {
      ways.push([x + step * STEP_MM, y + side * STEP_MM]);
      if (Math.abs(step) < ring) ways.push([x + side * STEP_MM, y + step * STEP_MM]);
    }
  return ways;
}

function nearest(ways: readonly Point[]): Point | null {
  const length = ([x, y]: Point): number => x * x + y * y;
  return ways.reduce<Point | null>((best, way) => (best === null || length(way) < length(best) ? way : best), null);
}

const shifted = ({ minX, minY, maxX, maxY }: Bounds, dx: number, dy: number): Bounds => ({
  minX: minX + dx,
  minY: minY + dy,
  maxX: maxX + dx,
  maxY: maxY + dy,
});

function isInside({ minX, minY, maxX, maxY }: Bounds, arena: Point): boolean {
  const all = arenaBounds(arena);
  return (
    minX >= all.minX - ROUNDING_MM &&
    minY >= all.minY - ROUNDING_MM &&
    maxX <= all.maxX + ROUNDING_MM &&
    maxY <= all.maxY + ROUNDING_MM
  );
}

/** The convex parts of all solid things of a course but these. */
export const solidsBut = ({ objects }: Scene, ids: readonly string[]): readonly Outline[] =>
  objects.filter(({ id }) => !ids.includes(id)).flatMap(solidParts);
