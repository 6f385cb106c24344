import type { Vec } from '#core/geometry';
import { squaredDistance } from '#scene/outline';
import type { Point } from '#scene/scene';
import { toPoint, toVec } from '../plane';

/**
 * How far a curve and the straight pieces that stand for it may lie apart, in mm. Chosen: less than a tenth of the spot
 * that a line sensor sees, so that no robot feels a corner.
 */
const APART_MM = 0.2;

/** The search for a whole millimetre goes on until the piece lies this many times as far from the curve. */
const TRIES = 3;

/**
 * A curve as a line of few points in whole mm: each piece reaches as far as it may, to a place that happens to lie close
 * to whole millimetres.
 *
 * @param curve places at most some mm apart, the first and the last in whole mm
 */
export function inWholeMm(curve: readonly Vec[]): readonly Point[] {
  const [start] = curve;
  if (start === undefined) return [];
  const points = [toPoint(start)];
  for (let at = 0; at < curve.length - 1;) {
    const from = points[points.length - 1] ?? toPoint(start);
    const next = furthest(curve, at, toVec(from));
    const point = toPoint(curve[next] ?? start);
    if (point[0] !== from[0] || point[1] !== from[1]) points.push(point);
    at = next;
  }
  return points;
}

/** The furthest place of a curve to which a straight piece from `from` stays close to it, or else the closest one. */
function furthest(curve: readonly Vec[], at: number, from: Vec): number {
  let best = at + 1;
  let bestApart = Infinity;
  for (let to = at + 1; to < curve.length; to += 1) {
    const place = curve[to];
    if (place === undefined) break;
    const apart = Math.sqrt(squaredApart(curve, at, to, from, toVec(toPoint(place))));
    if (apart <= APART_MM || (bestApart > APART_MM && apart <= bestApart)) {
      best = to;
      bestApart = Math.min(bestApart, apart);
    } else if (Math.sqrt(squaredApart(curve, at, to, from, place)) > TRIES * APART_MM) break;
  }
  return best;
}

/** The largest squared distance of the places between two of a curve from a straight piece. */
function squaredApart(curve: readonly Vec[], at: number, to: number, from: Vec, end: Vec): number {
  let most = 0;
  for (let index = at + 1; index <= to; index += 1) {
    const place = curve[index];
    if (place) most = Math.max(most, squaredDistance(place, from, end));
  }
  return most;
}
