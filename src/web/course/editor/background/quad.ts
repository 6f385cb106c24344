import { radOf } from '#core/angle';
import { exactCos, exactSin } from '#core/exact-math';
import type { Point } from '#scene/scene';

/**
 * The part of a picture that becomes the floor: four corners in whole pixels, y down, clockwise from the one that becomes
 * the upper left. In a photograph taken from aside, a sheet of paper is such a quadrilateral.
 */
export type Quad = readonly [Point, Point, Point, Point];

/** The extent of a picture in pixels. */
export interface Extent {
  readonly width: number;
  readonly height: number;
}

/** Shortest side of a part, in pixels. Chosen: less is a slip of the finger. */
const SHORTEST_PX = 16;

/** All of a picture. */
export const wholeOf = ({ width, height }: Extent): Quad => [
  [0, 0],
  [width, 0],
  [width, height],
  [0, height],
];

/** The part with one corner elsewhere, kept within the picture; the same as before if it would fold over or vanish. */
export function withCorner(quad: Quad, index: number, to: Point, extent: Extent): Quad {
  const moved = quad.map((corner, at) => (at === index ? within(to, extent) : corner)) as unknown as Quad;
  return isUsable(moved) ? moved : quad;
}

/** The part with one side shifted, as when cropping; side 0 is the upper one, the others follow clockwise. */
export function withSide(quad: Quad, index: number, by: Point, extent: Extent): Quad {
  const moved = quad.map((corner, at) =>
    at === index || at === (index + 1) % 4 ? within([corner[0] + by[0], corner[1] + by[1]], extent) : corner,
  ) as unknown as Quad;
  return isUsable(moved) ? moved : quad;
}

/** True if it goes clockwise round four corners, none of them pointing inwards, and is large enough to be meant. */
function isUsable(quad: Quad): boolean {
  return quad.every((corner, index) => {
    const next = quad[(index + 1) % 4] ?? corner;
    const last = quad[(index + 2) % 4] ?? corner;
    const [x, y] = [next[0] - corner[0], next[1] - corner[1]];
    const bend = x * (last[1] - next[1]) - y * (last[0] - next[0]);
    return bend > 0 && x * x + y * y >= SHORTEST_PX * SHORTEST_PX;
  });
}

const within = ([x, y]: Point, { width, height }: Extent): Point => [
  Math.round(Math.min(width, Math.max(0, x))),
  Math.round(Math.min(height, Math.max(0, y))),
];

/** The part turned about its middle, clockwise; made smaller where it would leave the picture. */
export function turnedQuad(quad: Quad, deg: number, extent: Extent): Quad {
  const cos = exactCos(radOf(deg));
  const sin = exactSin(radOf(deg));
  const [middleX, middleY] = middleOf(quad);
  const arms = quad.map(([x, y]): Point => {
    const [dx, dy] = [x - middleX, y - middleY];
    return [dx * cos - dy * sin, dx * sin + dy * cos];
  });
  const scale = Math.min(
    1,
    ...arms.map(([x]) => room(middleX, x, extent.width)),
    ...arms.map(([, y]) => room(middleY, y, extent.height)),
  );
  const turned = arms.map(([x, y]) => within([middleX + x * scale, middleY + y * scale], extent)) as unknown as Quad;
  return isUsable(turned) ? turned : quad;
}

function middleOf(quad: Quad): Point {
  const [x, y] = quad.reduce<Point>((sum, corner) => [sum[0] + corner[0], sum[1] + corner[1]], [0, 0]);
  return [x / 4, y / 4];
}

/** The share of an arm from a middle that fits between 0 and a length; from 1 on, all of it. */
function room(middle: number, arm: number, length: number): number {
  if (arm === 0) return 1;
  return arm > 0 ? (length - middle) / arm : middle / -arm;
}

/** The same part of a picture that has been turned by a quarter, clockwise: what was on the left is now above. */
export function quarterTurnedQuad(quad: Quad, { height }: Extent): Quad {
  const [one, two, three, four] = quad.map(([x, y]): Point => [height - y, x]) as unknown as Quad;
  return [four, one, two, three];
}

/** The part in a picture that is `factor` times as large. */
export const scaledQuad = (quad: Quad, factor: number): Quad =>
  quad.map(([x, y]): Point => [x * factor, y * factor]) as unknown as Quad;

/** Width and height of a part when it is straightened, in pixels: the means of its opposite sides. */
export function straightExtentOf([one, two, three, four]: Quad): Extent {
  const length = (from: Point, to: Point): number => {
    const [x, y] = [to[0] - from[0], to[1] - from[1]];
    return Math.sqrt(x * x + y * y);
  };
  return {
    width: Math.max(1, Math.round((length(one, two) + length(four, three)) / 2)),
    height: Math.max(1, Math.round((length(one, four) + length(two, three)) / 2)),
  };
}
