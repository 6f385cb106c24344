import type { Vec } from '#core/geometry';
import { isSame } from '#core/same';
import type { AnyObject } from '#scene/kinds/kind';
import { directionOf } from '#scene/outline';
import { sceneLimits, type Point, type SceneObject, type Shaped } from '#scene/scene';
import { toOwnFrame } from '#scene/shape/shape';
import { endOf, startOf } from '../drag';
import { lengthField, placeFields, turnField, type Field } from '../object-fields';
import { plus, rotationDeg, toPoint, toVec, turned, turnedAbout, within } from '../plane';
import { gridMm, intoArena, snappedPlace } from '../snap';
import type { Drag, Handle } from '../tools/tool';
import { hitShape, shifted } from './kind';

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
};

/** Shared by all shapes: a corner of their rectangle sizes them and a knob turns them. */
export const boxed = {
  ...placed,
  ...hitShape,
  extentMm: ({ size }: BoxObject) => Math.min(...size),
  handles: boxHandles,
  sized: sizedBox,
  dragged: draggedBox,
};

/** The fields of the place, size and rotation of a box. */
export const boxFields = <O extends BoxObject & SceneObject>(
  box: O,
  move: (box: O, dx: number, dy: number) => O = placed.moved,
): readonly Field<O>[] => [
  ...placeFields(box, box.at, move),
  lengthField('width', box.size[0], sceneLimits.blockMm, 10, (mm) => ({ ...box, size: [mm, box.size[1]] })),
  lengthField('height', box.size[1], sceneLimits.blockMm, 10, (mm) => ({ ...box, size: [box.size[0], mm] })),
  turnField(box),
];

/** A corner that sizes a box and a knob that turns it. */
function boxHandles(box: BoxObject, reachMm: number): readonly Handle[] {
  const { x: cos, y: sin } = directionOf(box.angle);
  const [halfX, halfY] = [box.size[0] / 2, box.size[1] / 2];
  const corner = { x: box.at[0] + halfX * cos - halfY * sin, y: box.at[1] + halfX * sin + halfY * cos };
  return [{ kind: 'size', at: corner, id: box.id }, knobAbove(box, box.size[1], reachMm)];
}

/** The knob that turns a box, above the middle of its own upper side. */
export function knobAbove({ id, at, angle }: Placed, heightMm: number, reachMm: number): Handle {
  const { x: cos, y: sin } = directionOf(angle);
  const byMm = heightMm / 2 + 2 * reachMm;
  return { kind: 'rotate', at: { x: at[0] - sin * byMm, y: at[1] + cos * byMm }, id };
}

/** Shortest sides of a dragged box, in mm. Chosen: it can still be seen and grabbed. */
const SMALLEST_MM = 10;

/** The upright box between where a drag began and where it is, inside the arena. */
function draggedBox<O extends BoxObject>(box: O, drag: Drag, arena: Point): O {
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

/** A box with its upper right corner (in its own frame) at a place; the corner opposite stays where it is. */
function sizedBox<O extends BoxObject>(box: O, place: Vec, { free, reachMm }: Drag): O | null {
  const own = toOwnFrame(box, place);
  const opposite = { x: -box.size[0] / 2, y: -box.size[1] / 2 };
  const side = (mm: number): number => boxSide(free ? mm : gridMm(mm, reachMm));
  const size: Point = [side(own.x - opposite.x), side(own.y - opposite.y)];
  if (isSame(size, box.size)) return null;
  const middle = { x: opposite.x + size[0] / 2, y: opposite.y + size[1] / 2 };
  const at = toPoint(plus(toVec(box.at), turned(middle, box.angle)));
  return { ...box, at, size };
}
