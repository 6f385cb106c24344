import { exactCos, exactSin } from '#core/exact-math';
import type { Vec } from '#core/geometry';
import {
  boundsOfOutline,
  boxOutline,
  directionOf,
  lengthOf,
  movedOutline,
  squaredDistance,
  type Bounds,
  type Outline,
} from '../outline';
import { figureOf } from './polygon';
import type { Point, Shaped } from '../scene';

/** The shapes that a body or a zone can have. */
export const shapeNames = ['rectangle', 'round', 'polygon'] as const;
export type ShapeName = (typeof shapeNames)[number];

/** The shape of a body or a zone. */
export const shapeNameOf = ({ round, corners }: Shaped): ShapeName =>
  corners ? 'polygon' : round === true ? 'round' : 'rectangle';

/** Corners of the outline that stands for an ellipse. Chosen: within 0.5 mm of one of 400 mm; the sensors of a run know circles. */
const ELLIPSE_CORNERS = 48;

const unitCircle: Outline = Array.from({ length: ELLIPSE_CORNERS }, (_, index) => {
  const rad = (index * 2 * Math.PI) / ELLIPSE_CORNERS;
  return { x: exactCos(rad), y: exactSin(rad) };
});

/** The outline of a shape in its own frame, about its middle, counter-clockwise; that of a polygon may be concave. mm. */
export function ownOutline({
  size: [width, height],
  round,
  corners,
}: Pick<Shaped, 'size' | 'round' | 'corners'>): Outline {
  if (corners) return figureOf(corners).corners.map(({ x, y }) => ({ x: (x - 0.5) * width, y: (y - 0.5) * height }));
  if (round === true) return unitCircle.map(({ x, y }) => ({ x: (x * width) / 2, y: (y * height) / 2 }));
  return boxOutline({ at: [0, 0], size: [width, height], angle: 0 });
}

/** The outline of a shape in world mm, counter-clockwise; that of a polygon may be concave. */
export const shapeOutline = (shape: Shaped): Outline =>
  shape.corners || shape.round === true ? placedAt(shape, ownOutline(shape)) : boxOutline(shape);

/** The convex parts of a shape in its own frame, counter-clockwise. mm. */
export function ownParts(shape: Pick<Shaped, 'size' | 'round' | 'corners'>): readonly Outline[] {
  const outline = ownOutline(shape);
  if (!shape.corners) return [outline];
  const { parts } = figureOf(shape.corners);
  const outlines = parts.map((part) => part.map((index) => outline[index] ?? { x: 0, y: 0 }));
  const solid = outlines.filter(isBody);
  return solid.length === 0 ? [boxOutline({ at: [0, 0], size: shape.size, angle: 0 })] : solid;
}

/** The convex parts of a shape in world mm, counter-clockwise. */
export const shapeParts = (shape: Shaped): readonly Outline[] =>
  shape.corners ? ownParts(shape).map((part) => placedAt(shape, part)) : [shapeOutline(shape)];

const placedAt = ({ at, angle }: Shaped, outline: Outline): Outline =>
  movedOutline(outline, { x: at[0], y: at[1] }, directionOf(angle));

/** Parts narrower than this, in mm, are left out: nothing feels them, and the physics cannot hold them. */
const NARROWEST_MM = 0.2;

/** True if a convex part is wide enough everywhere to be something. */
function isBody(part: Outline): boolean {
  return part.every((from, index) => {
    const to = part[(index + 1) % part.length] ?? from;
    const length = lengthOf(to.x - from.x, to.y - from.y);
    const across = part.map((corner) => (to.x - from.x) * (corner.y - from.y) - (to.y - from.y) * (corner.x - from.x));
    return length > NARROWEST_MM && Math.max(...across) > NARROWEST_MM * length;
  });
}

/** The smallest rectangle along the axes around a shape. World mm. */
export const shapeBounds = (shape: Shaped): Bounds =>
  shape.round === true ? ellipseBounds(shape) : boundsOfOutline(shapeOutline(shape));

function ellipseBounds({ at: [x, y], size, angle }: Shaped): Bounds {
  const { x: cos, y: sin } = directionOf(angle);
  const [halfX, halfY] = [size[0] / 2, size[1] / 2];
  const reachX = lengthOf(halfX * cos, halfY * sin);
  const reachY = lengthOf(halfX * sin, halfY * cos);
  return { minX: x - reachX, minY: y - reachY, maxX: x + reachX, maxY: y + reachY };
}

/** A place in a shape's own frame, about its middle. */
export function toOwnFrame({ at, angle }: Pick<Shaped, 'at' | 'angle'>, place: Vec): Vec {
  const { x: cos, y: sin } = directionOf(angle);
  const x = place.x - at[0];
  const y = place.y - at[1];
  return { x: x * cos + y * sin, y: y * cos - x * sin };
}

/** True if a place lies inside an outline, which may be concave, or at most `edgeMm` from its edge. */
export function outlineHolds(outline: Outline, place: Vec, edgeMm: number): boolean {
  let isInside = false;
  for (const [index, from] of outline.entries()) {
    const to = outline[(index + 1) % outline.length] ?? from;
    if (squaredDistance(place, from, to) <= edgeMm * edgeMm) return true;
    const isAbove = from.y > place.y;
    if (isAbove === to.y > place.y) continue;
    if (place.x < from.x + ((to.x - from.x) * (place.y - from.y)) / (to.y - from.y)) isInside = !isInside;
  }
  return isInside;
}

/** A polygon through corners in world mm that make one (`polygonFault`): upright, its corners whole mm. */
export function polygonThrough(
  corners: readonly Point[],
): Pick<Shaped, 'at' | 'size' | 'angle'> & { readonly corners: readonly Point[] } {
  const { minX, minY, maxX, maxY } = boundsOfOutline(corners.map(([x, y]) => ({ x, y })));
  const at: Point = [Math.round((minX + maxX) / 2), Math.round((minY + maxY) / 2)];
  return {
    at,
    size: [maxX - minX, maxY - minY],
    angle: 0,
    corners: corners.map(([x, y]): Point => [x - minX, y - minY]),
  };
}
