import type { Vec } from '#core/geometry';
import type { Point } from '#scene/scene';
import { distanceMm, middleBetween, toPoint, toVec, turned, turnedAbout } from '../plane';
import type { Handle } from '../tools/tool';

/** The handles of a straight line: its ends, and a knob beside its middle, on its left. */
export function lineHandles(
  id: string,
  [start, end]: readonly [Point, Point],
  widthMm: number,
  reachMm: number,
): readonly Handle[] {
  const [from, to] = [toVec(start), toVec(end)];
  return [
    { kind: 'from', at: from, id },
    { kind: 'to', at: to, id },
    { kind: 'rotate', at: beside(from, to, widthMm / 2 + 2 * reachMm), id },
  ];
}

function beside(from: Vec, to: Vec, byMm: number): Vec {
  const length = distanceMm(from, to);
  if (length === 0) return from;
  const { x, y } = middleBetween(from, to);
  return { x: x - ((to.y - from.y) / length) * byMm, y: y + ((to.x - from.x) / length) * byMm };
}

/**
 * A straight line turned in whole mm. Its extent is rounded, not its ends, and its middle to one side: otherwise it
 * would wander and shrink with every tap.
 */
export function turnedEnds(from: Point, to: Point, pivot: Vec, angleDeg: number): readonly [Point, Point] {
  const extent = turnedExtent(from, to, angleDeg);
  const middle = turnedAbout(middleBetween(toVec(from), toVec(to)), pivot, angleDeg);
  const start = toPoint({
    x: Math.floor(middle.x + NEARLY_WHOLE) - Math.floor(extent[0] / 2),
    y: Math.floor(middle.y + NEARLY_WHOLE) - Math.floor(extent[1] / 2),
  });
  return [start, toPoint({ x: start[0] + extent[0], y: start[1] + extent[1] })];
}

/** The displacement from one place to another after a rotation, in whole mm. */
export function turnedExtent(from: Point, to: Point, angleDeg: number): Point {
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
