import { wrappedDeg } from '#core/angle';
import type { Vec } from '#core/geometry';
import type { AnyObject } from '#scene/kinds/kind';
import { distanceToEdge, distanceToOutline, overlapMm, type Bounds, type Outline } from '#scene/outline';
import type { Point, Scene, SceneObject, Shaped } from '#scene/scene';
import { outlineHolds, shapeOutline, shapeParts } from '#scene/shape/shape';
import type { Field } from '../object-fields';
import { toPoint } from '../plane';
import type { Drag, Handle, ToolOptions } from '../tools/tool';

/** A kind of object as the tools and the list of objects know it. World mm. */
export interface EditorKind<O extends AnyObject = SceneObject> {
  /** Order of drawing: zones, then strokes (1) and words (2) on the floor, then solid things (3). */
  readonly layer: 0 | 1 | 2 | 3;
  /** Its place in its number fields, which the grid attracts; of a line its start. */
  place(object: O): Point;
  /** A line's displacement from one end to the other; `null` for anything but a line. */
  span(object: O): Vec | null;
  /** The place it turns about. Turned about it, it stays where it is, so that eight taps lead back. */
  middle(object: O): Vec;
  /** Its extent for the pointer: a wall's length, a box's shorter side, the longer side around a stroke or words. */
  extentMm(object: O): number;
  /** Distance of a place from it; 0 on it. */
  distanceMm(object: O, place: Vec): number;
  /** True if it has a place in common with a convex outline; the edge counts. `around`: the rectangle around the outline. */
  meets(object: O, outline: Outline, around: Bounds): boolean;
  /** Moved by whole mm; the caller sees to it that it stays within what a course may hold. */
  moved(object: O, dx: number, dy: number): O;
  /** Turned counter-clockwise about a place. */
  turned(object: O, pivot: Vec, angleDeg: number): O;
  /** Mirrored at the upright (`x`) or the level line (`y`) through this place, in whole mm; words stay readable. */
  mirrored(object: O, axis: Axis, atMm: number): O;
  /** Made larger or smaller about a place, along the arena's x and y. Lines keep their width. `null`: it cannot be so. */
  scaled(object: O, about: Vec, factor: Vec): O | null;
  /** The points where it can be grabbed. `reachMm`: of the pointer; knobs stand twice as far from it. */
  handles(object: O, reachMm: number): readonly Handle[];
  /**
   * With the corner or side that its handle holds at a place; left out: it is scaled like several things. `side`: see
   * `Handle`. `null`: nothing changes.
   */
  sized?(object: O, side: Point, place: Vec, drag: Drag): O | null;
  /** With the end that a handle holds at a place; left out: it has no such handle. `null`: nothing changes. */
  endMoved?(object: O, end: 'from' | 'to', place: Vec, drag: Drag, scene: Scene): O | null;
  /** With a point of it dragged to a place, or a new one there; left out: it has no such handle. `null`: nothing changes. */
  pointMoved?(object: O, handle: Handle, place: Vec, drag: Drag, scene: Scene): O | null;
  /** Without one of its points; left out: none can go. `null`: this one has to stay. */
  withoutPoint?(object: O, index: number): O | null;
  /** Its fields, in the order of a list. */
  fields(object: O): readonly Field<O>[];
  /** A new one in the size and look that the tools are set to; `null`: the course has no room for it. */
  made(id: string, at: Point, scene: Scene, options: ToolOptions): O | null;
  /** A new one made by a drag instead of a tap; left out: a drag draws it in another manner. */
  dragged?(object: O, drag: Drag, arena: Point): O;
}

/** The axis of a mirror image: `x` swaps left and right, `y` up and down. */
export type Axis = 'x' | 'y';

/** A place mirrored at a line. */
export const mirroredPoint = ([x, y]: Point, axis: Axis, atMm: number): Point =>
  toPoint(axis === 'x' ? { x: 2 * atMm - x, y } : { x, y: 2 * atMm - y });

/** A direction mirrored, in degrees. */
export const mirroredDeg = (angleDeg: number, axis: Axis): number =>
  wrappedDeg(axis === 'x' ? 180 - angleDeg : -angleDeg);

/** A place moved away from another, or towards it, by factors. */
export const scaledPoint = ([x, y]: Point, about: Vec, factor: Vec): Point =>
  toPoint({ x: about.x + (x - about.x) * factor.x, y: about.y + (y - about.y) * factor.y });

/** Hit where a convex outline is. */
export const hitWithin = <O extends AnyObject>(
  outline: (object: O) => Outline,
): Pick<EditorKind<O>, 'distanceMm' | 'meets'> => ({
  distanceMm: (object, place) => distanceToOutline(outline(object), place),
  meets: (object, other) => overlapMm(outline(object), other) >= 0,
});

/** Hit where a rectangle, an ellipse or a polygon is. */
export const hitShape: Pick<EditorKind<AnyObject & Shaped>, 'distanceMm' | 'meets'> = {
  distanceMm(shape, place) {
    const outline = shapeOutline(shape);
    return outlineHolds(outline, place, 0) ? 0 : distanceToEdge(outline, place);
  },
  meets: (shape, other) => shapeParts(shape).some((part) => overlapMm(part, other) >= 0),
};

/** The longer side of a rectangle. */
export const longerSide = ({ minX, minY, maxX, maxY }: Bounds): number => Math.max(maxX - minX, maxY - minY);

/** A place moved by whole mm. */
export const shifted = ([x, y]: Point, dx: number, dy: number): Point => [x + dx, y + dy];
