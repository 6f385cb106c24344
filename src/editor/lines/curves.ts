import { exactAtan2, exactCos, exactSin } from '#core/exact-math';
import type { Vec } from '#core/geometry';
import type { Bounds } from '#scene/outline';
import { distanceMm } from '../plane';

/** Distance of the places of a curve, in mm, and the most there are; then they lie further apart. */
const STEP_MM = 1;
const MOST_PLACES = 4000;

const PI = Math.PI;

/** A larger radius than this, in mm, is a straight line: twice the longest arena. */
const STRAIGHT_MM = 20_000;

/** An arc of a circle as places along it, both ends included. Angles in rad; `sweep` is positive counter-clockwise. */
export const arc = (centre: Vec, radiusMm: number, from: number, sweep: number): readonly Vec[] =>
  ellipsePart(centre, { x: radiusMm, y: radiusMm }, from, sweep);

function ellipsePart(centre: Vec, radii: Vec, from: number, sweep: number): readonly Vec[] {
  const lengthMm = Math.max(radii.x, radii.y) * Math.abs(sweep);
  const pieces = Math.max(2, Math.min(MOST_PLACES, Math.ceil(lengthMm / STEP_MM)));
  return Array.from({ length: pieces + 1 }, (_, index) => {
    const angle = from + (sweep * index) / pieces;
    return { x: centre.x + radii.x * exactCos(angle), y: centre.y + radii.y * exactSin(angle) };
  });
}

/** The ellipse within a rectangle, from its right once round. */
export function oval({ minX, minY, maxX, maxY }: Bounds): readonly Vec[] {
  const centre = { x: (minX + maxX) / 2, y: (minY + maxY) / 2 };
  const around = ellipsePart(centre, { x: (maxX - minX) / 2, y: (maxY - minY) / 2 }, 0, 2 * PI);
  return [...around.slice(0, -1), ...around.slice(0, 1)];
}

/** A rectangle with round corners, from the right end of its lower side once round. */
export function roundedRectangle({ minX, minY, maxX, maxY }: Bounds, radiusMm: number): readonly (readonly Vec[])[] {
  const [left, right, bottom, top] = [minX + radiusMm, maxX - radiusMm, minY + radiusMm, maxY - radiusMm];
  return [
    arc({ x: right, y: bottom }, radiusMm, -PI / 2, PI / 2),
    arc({ x: right, y: top }, radiusMm, 0, PI / 2),
    arc({ x: left, y: top }, radiusMm, PI / 2, PI / 2),
    arc({ x: left, y: bottom }, radiusMm, PI, PI / 2),
  ];
}

/** The arc from one place to another through a third; the straight line when the three lie on one. */
export function arcThrough(from: Vec, to: Vec, through: Vec): readonly Vec[] {
  const centre = centreOf(from, to, through);
  if (centre === null) return [from, to];
  const angleOf = ({ x, y }: Vec): number => exactAtan2(y - centre.y, x - centre.x);
  const start = angleOf(from);
  const toEnd = positive(angleOf(to) - start);
  const isLeft = positive(angleOf(through) - start) <= toEnd;
  const places = arc(centre, distanceMm(centre, from), start, isLeft ? toEnd : toEnd - 2 * PI);
  return [from, ...places.slice(1, -1), to];
}

/** An angle brought to 0 … 2π. */
const positive = (angle: number): number => (angle < 0 ? angle + 2 * PI : angle);

/** The centre of the circle through three places; `null` when they lie on a line, or nearly. */
function centreOf(a: Vec, b: Vec, c: Vec): Vec | null {
  const [bx, by, cx, cy] = [b.x - a.x, b.y - a.y, c.x - a.x, c.y - a.y];
  const twice = 2 * (bx * cy - by * cx);
  if (twice === 0) return null;
  const [b2, c2] = [bx * bx + by * by, cx * cx + cy * cy];
  const away = { x: (cy * b2 - by * c2) / twice, y: (bx * c2 - cx * b2) / twice };
  return distanceMm(away, { x: 0, y: 0 }) > STRAIGHT_MM ? null : { x: a.x + away.x, y: a.y + away.y };
}
