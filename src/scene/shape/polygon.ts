import type { Vec } from '#core/geometry';
import type { Outline } from '../outline';
import type { Point } from '../scene';

/** The area that corners enclose, in the square of their unit. */
export const areaOf = (corners: readonly Point[]): number => Math.abs(doubleArea(corners)) / 2;

/** Twice the area, positive if the corners go round counter-clockwise. */
function doubleArea(corners: readonly Point[]): number {
  let sum = 0;
  let [x, y] = corners.at(-1) ?? [0, 0];
  for (const [nextX, nextY] of corners) {
    sum += x * nextY - y * nextX;
    [x, y] = [nextX, nextY];
  }
  return sum;
}

/** More than 0: the way from `a` over `b` to `c` bends to the left. */
export const bend = (a: Point, b: Point, c: Point): number =>
  (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]);

/** The figure of a polygon, made ready once: corners from 0 to 1 along both axes, and how it falls into convex parts. */
export interface Figure {
  /** Counter-clockwise. */
  readonly corners: Outline;
  /** Convex parts, counter-clockwise, as places in `corners`. */
  readonly parts: readonly (readonly number[])[];
}

const figures = new WeakMap<readonly Point[], Figure>();

/** The figure of corners that make a polygon (`polygonFault`). The same corners always give the same parts. */
export function figureOf(given: readonly Point[]): Figure {
  const known = figures.get(given);
  if (known) return known;
  const corners = doubleArea(given) < 0 ? [...given].reverse() : given;
  const [xs, ys] = [corners.map(([x]) => x), corners.map(([, y]) => y)];
  const [left, bottom] = [Math.min(...xs), Math.min(...ys)];
  const [width, height] = [Math.max(...xs) - left, Math.max(...ys) - bottom];
  const unit = corners.map(([x, y]): Vec => ({ x: (x - left) / width, y: (y - bottom) / height }));
  const figure = { corners: unit, parts: joined(triangles(corners), corners) };
  figures.set(given, figure);
  return figure;
}

/** Cuts off one corner after the other that has none of the others inside (ear clipping). */
function triangles(corners: readonly Point[]): (readonly number[])[] {
  const isStraight = (left: readonly number[], place: number): boolean => bendAt(left, place, corners) === 0;
  const all = corners.map((_, index) => index);
  const left = all.filter((place) => !isStraight(all, place));
  const cut: (readonly number[])[] = [];
  while (left.length > 3) {
    const ear = left.findIndex((_, place) => isEar(left, place, corners));
    if (ear >= 0) cut.push(earAt(left, ear));
    // What is cut may leave corners in a straight line, which enclose nothing.
    const gone = ear >= 0 ? ear : left.findIndex((_, place) => isStraight(left, place));
    left.splice(Math.max(0, gone), 1);
  }
  return [...cut, left];
}

const earAt = (left: readonly number[], place: number): readonly [number, number, number] => [
  left[(place + left.length - 1) % left.length] ?? 0,
  left[place] ?? 0,
  left[(place + 1) % left.length] ?? 0,
];

function bendAt(left: readonly number[], place: number, corners: readonly Point[]): number {
  const [a, b, c] = earAt(left, place).map((index) => corners[index] ?? [0, 0]) as [Point, Point, Point];
  return bend(a, b, c);
}

function isEar(left: readonly number[], place: number, corners: readonly Point[]): boolean {
  const ear = earAt(left, place);
  const [a, b, c] = ear.map((index) => corners[index] ?? [0, 0]) as [Point, Point, Point];
  if (bend(a, b, c) <= 0) return false;
  return left.every((index) => {
    const corner = corners[index] ?? a;
    return ear.includes(index) || bend(a, b, corner) < 0 || bend(b, c, corner) < 0 || bend(c, a, corner) < 0;
  });
}

/** Takes parts that share an edge together as long as they stay convex (Hertel and Mehlhorn). */
function joined(parts: (readonly number[])[], corners: readonly Point[]): readonly (readonly number[])[] {
  for (let one = 0; one < parts.length; one++) {
    for (let other = one + 1; other < parts.length; other++) {
      const both = joinedPair(parts[one] ?? [], parts[other] ?? []);
      if (!both || !isConvex(both, corners)) continue;
      parts[one] = both;
      parts.splice(other, 1);
      other = one; // what did not fit before may fit now
    }
  }
  return parts;
}

/** Two parts as one, if they have an edge in common. */
function joinedPair(one: readonly number[], other: readonly number[]): readonly number[] | null {
  for (const [place, from] of one.entries()) {
    const to = one[(place + 1) % one.length] ?? from;
    const back = other.indexOf(to);
    if (back < 0 || other[(back + 1) % other.length] !== from) continue;
    const rest = Array.from({ length: other.length - 2 }, (_, index) => other[(back + 2 + index) % other.length] ?? 0);
    return [...one.slice(0, place + 1), ...rest, ...one.slice(place + 1)];
  }
  return null;
}

/** Sine of the least bend at a corner of a part. Chosen: the physics takes what is straighter for a straight line. */
const LEAST_BEND = 1e-3;

function isConvex(part: readonly number[], corners: readonly Point[]): boolean {
  return part.every((_, place) => {
    const [a, b, c] = earAt(part, place).map((index) => corners[index] ?? [0, 0]) as [Point, Point, Point];
    const [before, after] = [squared(a, b), squared(b, c)];
    return bend(a, b, c) > LEAST_BEND * Math.sqrt(before * after);
  });
}

const squared = (a: Point, b: Point): number => (b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1]);
