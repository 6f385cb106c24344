import type { Vec } from '#core/geometry';
import { isSame } from '#core/same';
import { boundsOf } from '#scene/kinds/index';
import { overlapMm, squaredDistance, type Bounds } from '#scene/outline';
import { paintColors } from '#scene/paint/paint';
import { sceneLimits, type Point, type Stroke } from '#scene/scene';
import { cornerRadius, withCornerRadius } from '../lines/round-corners';
import { endFields, lengthField, placeFields, type Field } from '../object-fields';
import { distanceMm, minus, toPoint, toVec, turnedAbout } from '../plane';
import { snappedTo, strokeEnds } from '../snap';
import { boundsHandles } from '../size-handles';
import { longerSide, mirroredPoint, scaledPoint, shifted, type EditorKind } from './kind';
import { lineHandles, turnedEnds } from './line';

/** Length of a line that is added without a pointer, in mm. Chosen: two cells of a maze. */
const NEW_MM = 300;

/** Painted lines. One of two points is straight: its ends move alone, a drawn one moves as a whole. */
export const stroke: EditorKind<Stroke> = {
  layer: 1,
  place: ({ points }) => points[0] ?? [0, 0],
  span({ points }) {
    const [first, last] = [points[0], points[points.length - 1]];
    return first && last ? minus(toVec(last), toVec(first)) : null;
  },
  middle: middleOfInk,
  extentMm: (stroke) => longerSide(boundsOf(stroke)),
  distanceMm: distanceTo,
  meets: (stroke, outline, around) =>
    somePiece(stroke, around, (from, to) => overlapMm([toVec(from), toVec(to)], outline) >= -stroke.width / 2),
  moved,
  turned: (stroke, pivot, angleDeg) => ({ ...stroke, points: turnedPoints(stroke.points, pivot, angleDeg) }),
  mirrored: (stroke, axis, atMm) => ({
    ...stroke,
    points: stroke.points.map((point) => mirroredPoint(point, axis, atMm)),
  }),
  scaled(stroke, about, factor) {
    const points = stroke.points.map((point) => scaledPoint(point, about, factor));
    return isPressedTogether(points) && !isPressedTogether(stroke.points) ? null : { ...stroke, points };
  },
  handles(stroke, reachMm) {
    const { id, points, width } = stroke;
    const ends = endsOf(stroke);
    if (ends) return lineHandles(id, ends, width, reachMm);
    if (points.length < 2) return [];
    const around = boundsOf(stroke);
    const at = { x: middleOfInk(stroke).x, y: around.maxY + 2 * reachMm };
    return [...boundsHandles(around, id, reachMm), { kind: 'rotate', at, id }];
  },
  endMoved(stroke, end, place, { reachMm, free, lure }, scene) {
    const [first, last] = endsOf(stroke) ?? [];
    if (!first || !last) return null;
    const stays = end === 'from' ? last : first;
    const ends = strokeEnds(scene).filter((point) => point !== first && point !== last);
    const to = snappedTo(stays, place, { ends, walls: [] }, { size: scene.size, reachMm, free, lure });
    if (isSame(stays, to)) return null;
    return { ...stroke, points: end === 'from' ? [to, stays] : [stays, to] };
  },
  fields(stroke) {
    const [first] = stroke.points;
    const ends = endsOf(stroke);
    return [
      ...(ends ? endFields(...ends, (from, to) => ({ ...stroke, points: [from, to] })) : []),
      ...(first && !ends ? placeFields(stroke, first, moved) : []),
      lengthField('penWidth', stroke.width, sceneLimits.widthMm, 1, (width) => ({ ...stroke, width })),
      ...radiusFields(stroke),
      {
        ...{ kind: 'choice', name: 'color', value: stroke.color, choices: paintColors },
        with: (color: Stroke['color']) => ({ ...stroke, color }),
      },
    ];
  },
  made: (id, [x, y], _scene, { penWidth, penColor }) => ({
    type: 'stroke',
    id,
    points: [
      [x - NEW_MM / 2, y],
      [x + NEW_MM / 2, y],
    ],
    width: penWidth,
    color: penColor,
  }),
};

function radiusFields(stroke: Stroke): readonly Field<Stroke>[] {
  const radius = cornerRadius(stroke);
  if (radius === null) return [];
  const range = { min: 0, max: radius.mostMm };
  return [lengthField('radius', radius.mm, range, 10, (mm) => withCornerRadius(stroke, mm))];
}

/** The ends of a straight line; `null`: it is drawn. */
function endsOf({ points }: Stroke): readonly [Point, Point] | null {
  const [first, last] = points;
  return first && last && points.length === 2 ? [first, last] : null;
}

function moved(stroke: Stroke, dx: number, dy: number): Stroke {
  return { ...stroke, points: stroke.points.map((point) => shifted(point, dx, dy)) };
}

const isPressedTogether = ([first, ...rest]: readonly Point[]): boolean => rest.every((point) => isSame(point, first));

/** The length of a stroke's middle line, in mm. */
export const strokeLengthMm = ({ points }: Stroke): number =>
  points.reduce((sum, point, index) => sum + distanceMm(toVec(points[index - 1] ?? point), toVec(point)), 0);

/** The middle of the ink, not of the rectangle around it. */
function middleOfInk({ points }: Stroke): Vec {
  let x = 0;
  let y = 0;
  let length = 0;
  let before: Vec | null = null;
  for (const point of points) {
    const place = toVec(point);
    if (before) {
      const piece = distanceMm(before, place);
      x += ((before.x + place.x) / 2) * piece;
      y += ((before.y + place.y) / 2) * piece;
      length += piece;
    }
    before = place;
  }
  if (length > 0) return { x: x / length, y: y / length };
  return before ?? { x: 0, y: 0 };
}

function turnedPoints(points: readonly Point[], pivot: Vec, angleDeg: number): readonly Point[] {
  const [first, last] = points;
  if (points.length === 2 && first && last) return turnedEnds(first, last, pivot, angleDeg);
  // About a whole place quarter turns lose nothing.
  const whole = toVec(toPoint(pivot));
  return points.map((point) => toPoint(turnedAbout(toVec(point), whole, angleDeg)));
}

function distanceTo({ points, width }: Stroke, place: Vec): number {
  let squared = Infinity;
  let before = points[0];
  for (const point of points) {
    const [fromX, fromY] = before ?? point;
    squared = Math.min(squared, squaredDistance(place, { x: fromX, y: fromY }, { x: point[0], y: point[1] }));
    before = point;
  }
  return Math.max(0, Math.sqrt(squared) - width / 2);
}

/** True if a part of a stroke may lie in a rectangle: the rectangle around one of its pieces does. */
export const comesNear = (stroke: Stroke, around: Bounds): boolean => somePiece(stroke, around, () => true);

/** True if something holds for one of those pieces of a stroke that come near a rectangle. Most are ruled out quickly. */
function somePiece(
  { points, width }: Stroke,
  { minX, minY, maxX, maxY }: Bounds,
  holds: (from: Point, to: Point) => boolean,
): boolean {
  const reachMm = width / 2;
  let before = points[0];
  for (const point of points) {
    const from = before ?? point;
    before = point;
    if (Math.min(from[0], point[0]) - reachMm > maxX || Math.max(from[0], point[0]) + reachMm < minX) continue;
    if (Math.min(from[1], point[1]) - reachMm > maxY || Math.max(from[1], point[1]) + reachMm < minY) continue;
    if (holds(from, point)) return true;
  }
  return false;
}
