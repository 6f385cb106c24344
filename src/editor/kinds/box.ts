import type { Vec } from '#core/geometry';
import { isSame } from '#core/same';
import type { AnyObject } from '#scene/kinds/kind';
import { boundsOfOutline, directionOf } from '#scene/outline';
import { sceneLimits, type Point, type SceneObject, type Shaped } from '#scene/scene';
import { areaOf } from '#scene/shape/polygon';
import { toOwnFrame } from '#scene/shape/shape';
import { endOf, startOf } from '../drag';
import { lengthField, placeFields, turnField, type Field } from '../object-fields';
import { distanceMm, plus, rotationDeg, toPoint, toVec, turned, turnedAbout, within } from '../plane';
import { sizeSides } from '../size-handles';
import { gridMm, intoArena, snappedPlace } from '../snap';
import type { Drag, Handle } from '../tools/tool';
import { hitShape, mirroredPoint, scaledPoint, shifted, type Axis } from './kind';
import { drawnPolygon } from './shapes';

/** An object with a middle and a rotation. */
type Placed = AnyObject & Pick<Shaped, 'at' | 'angle'>;

/** An object that fills a rectangle, an ellipse or a polygon. */
type BoxObject = AnyObject & Shaped;

const turnedPlaced = <O extends Placed>(object: O, pivot: Vec, angleDeg: number): O => ({
  ...object,
  at: toPoint(turnedAbout(toVec(object.at), pivot, angleDeg)),
  angle: rotationDeg(object.angle + angleDeg),
});

/** Shared by all objects with a middle and a rotation. */
export const placed = {
  place: ({ at }: Placed) => at,
  span: () => null,
  middle: ({ at }: Placed) => toVec(at),
  moved: <O extends Placed>(object: O, dx: number, dy: number): O => ({ ...object, at: shifted(object.at, dx, dy) }),
  turned: turnedPlaced,
  // A rectangle looks the same upside down, and words must stay readable: the mirrored angle is the opposite one.
  mirrored: <O extends Placed & Pick<Shaped, 'corners'>>(object: O, axis: Axis, atMm: number): O => ({
    ...object,
    at: mirroredPoint(object.at, axis, atMm),
    angle: rotationDeg(-object.angle),
    ...(object.corners ? { corners: mirroredCorners(object.corners, axis) } : {}),
  }),
};

/** The corners of a polygon in its own frame, mirrored at the middle of its rectangle. */
function mirroredCorners(corners: readonly Point[], axis: Axis): readonly Point[] {
  const along = corners.map((corner) => corner[axis === 'x' ? 0 : 1]);
  const atMm = (Math.min(...along) + Math.max(...along)) / 2;
  return corners.map((corner) => mirroredPoint(corner, axis, atMm));
}

/** Shared by all shapes: corners and sides of their rectangle size them and a knob turns them. */
export const boxed = {
  ...placed,
  ...hitShape,
  extentMm: ({ size }: BoxObject) => Math.min(...size),
  handles: (box: BoxObject, reachMm: number): readonly Handle[] => [
    ...boxSizeHandles(box, reachMm),
    knobAbove(box, box.size[1], reachMm),
  ],
  scaled: scaledBox,
  sized: sizedBox,
  dragged: draggedBox,
};

/** The fields of the place, size and rotation of a box. */
export const boxFields = <O extends BoxObject & SceneObject>(
  box: O,
  move: (box: O, dx: number, dy: number) => O = placed.moved,
): readonly Field<O>[] => [
  ...placeFields(box, box.at, move),
  lengthField('length', box.size[0], sceneLimits.blockMm, 10, (mm) => ({ ...box, size: [mm, box.size[1]] })),
  lengthField('breadth', box.size[1], sceneLimits.blockMm, 10, (mm) => ({ ...box, size: [box.size[0], mm] })),
  turnField(box),
];

/** The handles at corners and sides that size a box. */
export function boxSizeHandles(
  box: Pick<BoxObject, 'id' | 'at' | 'size' | 'angle'>,
  reachMm: number,
): readonly Handle[] {
  const { x: cos, y: sin } = directionOf(box.angle);
  return sizeSides(box.size, reachMm).map((side) => {
    const [x, y] = [(side[0] * box.size[0]) / 2, (side[1] * box.size[1]) / 2];
    return {
      kind: 'size',
      id: box.id,
      side,
      at: { x: box.at[0] + x * cos - y * sin, y: box.at[1] + x * sin + y * cos },
    };
  });
}

/** The knob that turns a box, above the middle of its own upper side. */
export function knobAbove({ id, at, angle }: Placed, heightMm: number, reachMm: number): Handle {
  const { x: cos, y: sin } = directionOf(angle);
  const byMm = heightMm / 2 + 2 * reachMm;
  return { kind: 'rotate', at: { x: at[0] - sin * byMm, y: at[1] + cos * byMm }, id };
}

/** Shortest sides of a dragged box, in mm. Chosen: it can still be seen and grabbed. */
const SMALLEST_MM = 10;

/** The upright box between where a drag began and where it is, inside the arena; of a polygon the outline that was drawn. */
function draggedBox<O extends BoxObject>(box: O, drag: Drag, arena: Point): O {
  const drawn = box.corners ? drawnPolygon(drag.path, arena) : null;
  if (drawn) return { ...box, ...drawn };
  const [a, b] = [startOf(drag), endOf(drag)].map((place) => intoArena(snappedPlace(place, drag), arena)) as [Vec, Vec];
  return {
    ...box,
    at: toPoint({ x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 }),
    size: [boxSide(Math.abs(b.x - a.x), SMALLEST_MM), boxSide(Math.abs(b.y - a.y), SMALLEST_MM)],
  };
}

/** A side in whole mm within what a course may hold. */
const boxSide = (mm: number, leastMm: number = sceneLimits.blockMm.min): number =>
  Math.round(within(mm, { min: leastMm, max: sceneLimits.blockMm.max }));

/** A box with a corner or side (in its own frame) at a place; the opposite one stays where it is, or the middle. */
function sizedBox<O extends BoxObject>(box: O, side: Point, place: Vec, drag: Drag): O | null {
  const { x, y } = lured(box, place, drag);
  const size = kept(box.size, side, drag, [
    draggedSide(box.size[0], side[0], x.mm, { ...drag, free: drag.free || x.isLured }),
    draggedSide(box.size[1], side[1], y.mm, { ...drag, free: drag.free || y.isLured }),
  ]);
  if (isSame(size, box.size) || !isLargeEnough({ ...box, size })) return null;
  const stays = drag.alt === true ? 0 : 1;
  const middle = {
    x: (stays * side[0] * (size[0] - box.size[0])) / 2,
    y: (stays * side[1] * (size[1] - box.size[1])) / 2,
  };
  return { ...box, at: toPoint(plus(toVec(box.at), turned(middle, box.angle))), size };
}

/** A coordinate along an axis of a box, and whether a thing has attracted it. */
interface Along {
  readonly mm: number;
  readonly isLured: boolean;
}

/** A place in a box's own frame, drawn onto things where its sides are upright and level. */
function lured(box: BoxObject, place: Vec, { free, lure }: Drag): { readonly x: Along; readonly y: Along } {
  const isStraight = box.angle % 90 === 0 && !free;
  const [x, y] = isStraight ? [lure?.(place.x, 'x') ?? null, lure?.(place.y, 'y') ?? null] : [null, null];
  const own = toOwnFrame(box, { x: x ?? place.x, y: y ?? place.y });
  const isAcross = box.angle % 180 !== 0;
  return {
    x: { mm: own.x, isLured: (isAcross ? y : x) !== null },
    y: { mm: own.y, isLured: (isAcross ? x : y) !== null },
  };
}

/** The length of a box along one of its axes when the side at that end is dragged to a place. */
function draggedSide(lengthMm: number, end: number, placeMm: number, { free, reachMm, alt }: Drag): number {
  if (end === 0) return lengthMm;
  const mm = alt === true ? 2 * placeMm * end : placeMm * end + lengthMm / 2;
  return boxSide(free ? mm : gridMm(mm, reachMm));
}

/** With Shift both sides grow by the same factor: the larger one at a corner, that of the dragged one at a side. */
function kept(before: Point, side: Point, { keeps }: Drag, wanted: Point): Point {
  if (keeps !== true) return wanted;
  const factors = [wanted[0] / before[0], wanted[1] / before[1]] as const;
  const factor = side[0] === 0 ? factors[1] : side[1] === 0 ? factors[0] : Math.max(...factors);
  return [boxSide(before[0] * factor), boxSide(before[1] * factor)];
}

/** A turned box grows along each of its own axes as far as the arena's axes do there. */
function scaledBox<O extends BoxObject>(box: O, about: Vec, factor: Vec): O | null {
  const { x: cos, y: sin } = directionOf(box.angle);
  const size: Point = [
    boxSide(box.size[0] * distanceMm(ORIGIN, { x: cos * factor.x, y: sin * factor.y })),
    boxSide(box.size[1] * distanceMm(ORIGIN, { x: sin * factor.x, y: cos * factor.y })),
  ];
  const scaled = { ...box, at: scaledPoint(box.at, about, factor), size };
  return isLargeEnough(scaled) ? scaled : null;
}

const ORIGIN: Vec = { x: 0, y: 0 };

/** True if a polygon still encloses as much as a course wants of it; other shapes always do. */
export function isLargeEnough({ corners, size }: Pick<Shaped, 'corners' | 'size'>): boolean {
  if (!corners) return true;
  const { minX, minY, maxX, maxY } = boundsOfOutline(corners.map(toVec));
  return (areaOf(corners) / (maxX - minX) / (maxY - minY)) * size[0] * size[1] >= sceneLimits.leastAreaMm2;
}
