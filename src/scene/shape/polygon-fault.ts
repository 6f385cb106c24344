import type { Point } from '../scene';
import { bend } from './polygon';

/** Reasons why corners are no polygon: two edges meet that are not neighbours, or they enclose nothing. */
export type PolygonFault =
  /** Numbers of the edges; edge 0 goes from corner 0 to corner 1. */
  { readonly code: 'crossing'; readonly one: number; readonly other: number } | { readonly code: 'flat' };

/** The fault of a polygon's corners; `null`: none. */
export function polygonFault(corners: readonly Point[]): PolygonFault | null {
  const count = corners.length;
  const corner = (index: number): Point => corners[index % count] ?? [0, 0];
  if (corners.every((_, index) => bend(corner(index), corner(index + 1), corner(index + 2)) === 0))
    return { code: 'flat' };
  for (let one = 0; one < count; one++) {
    if (turnsBack(corner(one), corner(one + 1), corner(one + 2))) return { code: 'crossing', one, other: (one + 1) % count }; // prettier-ignore
    for (let other = one + 2; other < count; other++) {
      if ((other + 1) % count === one) continue;
      if (edgesMeet(corner(one), corner(one + 1), corner(other), corner(other + 1))) return { code: 'crossing', one, other }; // prettier-ignore
    }
  }
  return null;
}

/** True if an edge runs back along the one before it, or has no length. */
function turnsBack(a: Point, b: Point, c: Point): boolean {
  const ahead = (b[0] - a[0]) * (c[0] - b[0]) + (b[1] - a[1]) * (c[1] - b[1]);
  return bend(a, b, c) === 0 && ahead <= 0;
}

function edgesMeet(a: Point, b: Point, c: Point, d: Point): boolean {
  const [toC, toD, toA, toB] = [bend(a, b, c), bend(a, b, d), bend(c, d, a), bend(c, d, b)];
  if (((toC > 0 && toD < 0) || (toC < 0 && toD > 0)) && ((toA > 0 && toB < 0) || (toA < 0 && toB > 0))) return true;
  return (
    (toC === 0 && isBetween(a, b, c)) ||
    (toD === 0 && isBetween(a, b, d)) ||
    (toA === 0 && isBetween(c, d, a)) ||
    (toB === 0 && isBetween(c, d, b))
  );
}

/** True if a place on the line through two others lies between them. */
const isBetween = (a: Point, b: Point, [x, y]: Point): boolean =>
  x >= Math.min(a[0], b[0]) && x <= Math.max(a[0], b[0]) && y >= Math.min(a[1], b[1]) && y <= Math.max(a[1], b[1]);
