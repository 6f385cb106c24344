import type { Vec } from '#core/geometry';
import { squaredDistance } from './outline';
import type { Point } from './scene';

/** Chosen: thinner than any line, and half of what a pen on a school tablet jitters. */
export const TOLERANCE_MM = 1;

/**
 * The coarsest for a finger, which trembles by more than a millimetre and is reported in whole pixels. Chosen: less
 * than the radius of the spot that a line sensor sees (2.5 mm on all robots here), so that no sensor notices it.
 */
export const FINGER_TOLERANCE_MM = 2;

/**
 * A drawn line with as few points as needed: no place of the drawing is further from the result than the tolerance and
 * the rounding to whole mm (Ramer, Douglas and Peucker). First and last place stay, one after the other never the same.
 *
 * @param path world mm; at least one place
 */
export function simplified(path: readonly Vec[], toleranceMm: number = TOLERANCE_MM): readonly Point[] {
  const points: Point[] = [];
  for (const { x, y } of thinned(path, toleranceMm)) {
    const point: Point = [wholeMm(x), wholeMm(y)];
    const last = points[points.length - 1];
    if (last?.[0] !== point[0] || last[1] !== point[1]) points.push(point);
  }
  return points;
}

/** Rounded, and never −0, which would not survive a file. */
const wholeMm = (mm: number): number => Math.round(mm) + 0;

/**
 * A line is simplified in pieces of this many places, whose ends stay. The work then grows with the length of the line,
 * not with its square, however it is drawn. Chosen: 2 s of a pen that reports 1000 places a second.
 */
const PIECE = 2048;

/** The places of a path that are needed; the others lie no further from the lines between them than the tolerance. */
export function thinned(path: readonly Vec[], toleranceMm: number): readonly Vec[] {
  const squaredTolerance = toleranceMm * toleranceMm;
  const stays = new Uint8Array(path.length);
  const open: (readonly [from: number, to: number])[] = [];
  for (let from = 0; from < path.length; from += PIECE) {
    stays[from] = 1;
    open.push([from, Math.min(from + PIECE, path.length - 1)]);
  }
  stays[path.length - 1] = 1;
  for (let piece = open.pop(); piece; piece = open.pop()) {
    const [from, to] = piece;
    const furthest = furthestOf(path, from, to, squaredTolerance);
    if (furthest < 0) continue;
    stays[furthest] = 1;
    open.push([from, furthest], [furthest, to]);
  }
  return path.filter((_, index) => stays[index] === 1);
}

/** The place between two that is furthest from the straight line between them, or −1: none is beyond the tolerance. */
function furthestOf(path: readonly Vec[], from: number, to: number, squaredTolerance: number): number {
  const start = path[from];
  const end = path[to];
  if (!start || !end) return -1;
  let furthest = -1;
  let most = squaredTolerance;
  for (let index = from + 1; index < to; index++) {
    const place = path[index];
    if (!place) continue;
    const distance = squaredDistance(place, start, end);
    if (distance <= most) continue;
    furthest = index;
    most = distance;
  }
  return furthest;
}
