import type { Vec } from '#core/geometry';
import { convexHull } from '#scene/outline';
import { sceneLimits, type Point, type Shaped } from '#scene/scene';
import { polygonFault } from '#scene/shape/polygon-fault';
import { polygonThrough, shapeNameOf, type ShapeName } from '#scene/shape/shape';
import { simplified } from '#scene/simplify';
import type { Field } from '../object-fields';
import { toPoint, toVec } from '../plane';
import { intoArena } from '../snap';

/** The figure of a polygon before its corners are moved: a triangle. */
const TRIANGLE: readonly Point[] = [[0, 0], [2, 0], [1, 2]]; // prettier-ignore

/** The corners of a new body or zone: a triangle for a polygon, otherwise none. */
export const newCornersOf = (shape: ShapeName): Pick<Shaped, 'corners'> =>
  shape === 'polygon' ? { corners: TRIANGLE } : {};

/** The properties that give a new body its shape; `round` is left out unless it is true. */
export const bodyShape = (shape: ShapeName): { readonly round?: true; readonly corners?: readonly Point[] } => ({
  ...(shape === 'round' ? { round: true } : {}),
  ...newCornersOf(shape),
});

/** The field of a shape; a polygon that was chosen begins as a triangle. */
export const shapeField = <O extends Shaped>(
  object: O,
  choices: readonly ShapeName[],
  withShape: (bare: Omit<O, 'round' | 'corners'>, shape: ShapeName) => O,
): Field<O> => ({
  ...{ kind: 'choice', name: 'shape', value: shapeNameOf(object), choices },
  with(shape: ShapeName) {
    const { round: _round, corners: _corners, ...bare } = object;
    return withShape(bare, shape);
  },
});

/** How far a drawn outline may lie from the corners that stand for it, in mm: finer first. Chosen by eye. */
const TOLERANCES_MM = [2, 4, 8, 16, 32, 64];

/** A polygon shorter than this along an axis is none, in mm. Chosen: it can be seen and grabbed. */
const SMALLEST_MM = 10;

/**
 * The polygon whose outline a hand has drawn, closed by a straight line; if the outline crosses itself, its convex
 * hull. `null`: it encloses nothing, or is narrower than 10 mm.
 */
export function drawnPolygon(path: readonly Vec[], arena: Point): ReturnType<typeof polygonThrough> | null {
  const inside = path.map((place) => intoArena(place, arena));
  const [first] = inside;
  if (first === undefined) return null;
  const rings = TOLERANCES_MM.map((mm) => simplified([...inside, first], mm).slice(0, -1));
  const ring = rings.find(({ length }) => length <= sceneLimits.corners.max) ?? [];
  const corners = isPolygon(ring) ? ring : convexHull(ring.map(toVec)).map(toPoint);
  if (!isPolygon(corners)) return null;
  const polygon = polygonThrough(corners);
  return Math.min(...polygon.size) < SMALLEST_MM ? null : polygon;
}

const isPolygon = (corners: readonly Point[]): boolean =>
  corners.length >= sceneLimits.corners.min && polygonFault(corners) === null;
