import type { Vec } from '#core/geometry';
import type { Point, SceneObject, Stroke } from '#scene/scene';
import { distanceMm, eighths, middleBetween, toPoint, toVec, turned, turnedAbout } from './plane';

/** An object moved by whole mm; the caller sees to it that it stays within what a course may hold. */
export function movedBy(object: SceneObject, dx: number, dy: number): SceneObject {
  const by = ([x, y]: Point): Point => [x + dx, y + dy];
  switch (object.type) {
    case 'wall':
      return { ...object, from: by(object.from), to: by(object.to) };
    case 'stroke':
      return { ...object, points: object.points.map(by) };
    case 'mover':
      return { ...object, at: by(object.at), to: by(object.to) };
    case 'block':
    case 'fixed-block':
    case 'spikes':
    case 'target':
    case 'checkpoint':
    case 'forbidden':
    case 'label':
      return { ...object, at: by(object.at) };
    default:
      return object satisfies never;
  }
}

/**
 * The middle that an object turns about. Turning an object about it leaves it where it is, so that eight taps lead back:
 * of a stroke it is the middle of its ink, not of the rectangle around it.
 */
export function middleOf(object: SceneObject): Vec {
  switch (object.type) {
    case 'wall':
      return middleBetween(toVec(object.from), toVec(object.to));
    case 'stroke':
      return middleOfInk(object);
    case 'block':
    case 'fixed-block':
    case 'spikes':
    case 'target':
    case 'checkpoint':
    case 'forbidden':
    case 'label':
    case 'mover':
      return toVec(object.at);
    default:
      return object satisfies never;
  }
}

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

/** Whether an object can only be turned in eighths of a full turn. */
export const turnsInEighths = ({ type }: SceneObject): boolean => type !== 'wall' && type !== 'stroke';

/** An object turned counter-clockwise about a place; what knows only eighths takes the nearest. */
export function turnedObject(object: SceneObject, pivot: Vec, angleDeg: number): SceneObject {
  const about = (point: Point): Point => toPoint(turnedAbout(toVec(point), pivot, angleDeg));
  switch (object.type) {
    case 'wall': {
      const [from, to] = turnedEnds(object.from, object.to, pivot, angleDeg);
      return { ...object, from, to };
    }
    case 'stroke':
      return { ...object, points: turnedPoints(object.points, pivot, angleDeg) };
    case 'mover': {
      const at = about(object.at);
      const [x, y] = turnedExtent(object.at, object.to, angleDeg);
      return { ...object, at, to: toPoint({ x: at[0] + x, y: at[1] + y }), turn: turnAfter(object, angleDeg) };
    }
    case 'block':
    case 'fixed-block':
    case 'spikes':
    case 'target':
    case 'checkpoint':
    case 'forbidden':
    case 'label':
      return { ...object, at: about(object.at), turn: turnAfter(object, angleDeg) };
    default:
      return object satisfies never;
  }
}

const turnAfter = ({ turn }: { readonly turn: number }, angleDeg: number): number => eighths(turn + angleDeg / 45);

function turnedPoints(points: readonly Point[], pivot: Vec, angleDeg: number): readonly Point[] {
  const [first, last] = points;
  if (points.length === 2 && first && last) return turnedEnds(first, last, pivot, angleDeg);
  // About a whole place quarter turns lose nothing.
  const whole = toVec(toPoint(pivot));
  return points.map((point) => toPoint(turnedAbout(toVec(point), whole, angleDeg)));
}

/**
 * A straight line turned in whole mm. Its extent is rounded, not its ends, and its middle to one side: otherwise it
 * would wander and shrink with every tap.
 */
function turnedEnds(from: Point, to: Point, pivot: Vec, angleDeg: number): readonly [Point, Point] {
  const extent = turnedExtent(from, to, angleDeg);
  const middle = turnedAbout(middleBetween(toVec(from), toVec(to)), pivot, angleDeg);
  const start = toPoint({
    x: Math.floor(middle.x + NEARLY_WHOLE) - Math.floor(extent[0] / 2),
    y: Math.floor(middle.y + NEARLY_WHOLE) - Math.floor(extent[1] / 2),
  });
  return [start, toPoint({ x: start[0] + extent[0], y: start[1] + extent[1] })];
}

/** From one place to another after a rotation, in whole mm. */
function turnedExtent(from: Point, to: Point, angleDeg: number): Point {
  const before = { x: to[0] - from[0], y: to[1] - from[1] };
  const [x, y] = toPoint(turned(before, angleDeg));
  const isDiagonal = Math.abs(before.x) === Math.abs(before.y) && before.x !== 0;
  if (!isDiagonal || (x !== 0 && y !== 0)) return [x, y];
  return x === 0 ? [0, evenLength(y, before.x)] : [evenLength(x, before.x), 0];
}

/**
 * The length of a line that has come from a diagonal to lie level or upright. Two lengths may have had the same whole mm
 * as a diagonal; whole centimetres are what was meant.
 */
function evenLength(length: number, diagonal: number): number {
  const side = Math.abs(diagonal);
  const sign = length < 0 ? -1 : 1;
  const same = [Math.abs(length) - 1, Math.abs(length), Math.abs(length) + 1].filter(
    (mm) => Math.round(mm * Math.SQRT1_2) === side,
  );
  return sign * (same.find((mm) => mm % 10 === 0) ?? Math.abs(length));
}

/** Rounding errors of a rotation are smaller than this. */
const NEARLY_WHOLE = 1e-6;
