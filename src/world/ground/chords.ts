import { exactCos, exactSin } from '#core/exact-math';
import type { FloorPicture } from './floor-grid';
import type { Segment } from './segment';

/** Chords across a spot. Chosen: see docs/decisions/0015-ground-coverage.md. */
const CHORDS = 32;

/**
 * The chords are turned by this angle, in rad, against the piece next to the spot. Chosen: drawings often have right
 * angles and eighths of a turn, and an edge along the chords would come out worst.
 */
const TURN_RAD = 0.3926990816987241; // 22.5°

/** A picture on the floor is sampled at this interval in mm along a chord. Chosen: half of the finest cell. */
const PICTURE_STEP_MM = 0.5;

/** Distance of each chord from the middle and its weight, for a disc of radius 1: Gauss's rule for the disc (Chebyshev, second kind). */
const offsets: readonly number[] = Array.from({ length: CHORDS }, (_, i) =>
  exactCos((Math.PI * (i + 1)) / (CHORDS + 1)),
);
const weights: readonly number[] = Array.from({ length: CHORDS }, (_, i) => {
  const sin = exactSin((Math.PI * (i + 1)) / (CHORDS + 1));
  return (2 * sin * sin) / (CHORDS + 1);
});
const turnCos = exactCos(TURN_RAD);
const turnSin = exactSin(TURN_RAD);

/** The ground below all pieces: an even reflectance, or a picture. */
export type Under = number | FloorPicture;

// The parts of the present chord that nothing covers yet. Kept outside to save objects: a spot has 32 chords.
let starts = new Float64Array(64);
let ends = new Float64Array(64);
let count = 0;
// The chord itself: its foot and its direction. In an array, because each argument with a point becomes an object of its own.
const chord = new Float64Array(4);

/**
 * Mean reflectance of a disc, by chords. The covered intervals of a chord are computed exactly, piece by piece from the
 * topmost to the lowest, so crossings, ends and overpainted strokes come out as they are drawn.
 *
 * @param pieces from the highest layer to the lowest; the first one gives the chords their direction
 */
export function meanByChords(x: number, y: number, radius: number, pieces: readonly Segment[], under: Under): number {
  const [first] = pieces;
  if (!first) return typeof under === 'number' ? under : under.under(x, y, radius);
  const ux = first.ex * turnCos - first.ey * turnSin;
  const uy = first.ex * turnSin + first.ey * turnCos;
  chord[2] = ux;
  chord[3] = uy;
  let mean = 0;
  for (let i = 0; i < CHORDS; i++) {
    const offset = (offsets[i] ?? 0) * radius;
    const half = Math.sqrt(radius * radius - offset * offset);
    const px = x - offset * uy;
    const py = y + offset * ux;
    chord[0] = px;
    chord[1] = py;
    count = 1;
    starts[0] = -half;
    ends[0] = half;
    let sum = 0;
    for (const piece of pieces) {
      sum += piece.painted.reflectance * coveredAnew(piece);
      if (count === 0) break;
    }
    if (count > 0) sum += uncovered(px, py, ux, uy, under);
    mean += ((weights[i] ?? 0) * sum) / (2 * half);
  }
  return mean;
}

/** Length of the uncovered part that lies in a piece; it is covered from now on. */
function coveredAnew({ ax, ay, ex, ey, length, painted }: Segment): number {
  const px = chord[0] ?? NaN;
  const py = chord[1] ?? NaN;
  const ux = chord[2] ?? NaN;
  const uy = chord[3] ?? NaN;
  const half = painted.halfWidth;
  // The chord in the piece's frame: along and across of its foot and of its direction.
  const along = (px - ax) * ex + (py - ay) * ey;
  const across = (py - ay) * ex - (px - ax) * ey;
  const cos = ux * ex + uy * ey;
  const sin = uy * ex - ux * ey;
  // The straight part.
  let low = -Infinity;
  let high = Infinity;
  if (sin !== 0) {
    const one = (-half - across) / sin;
    const other = (half - across) / sin;
    low = Math.min(one, other);
    high = Math.max(one, other);
  } else if (Math.abs(across) > half) high = -Infinity;
  if (cos !== 0) {
    const one = -along / cos;
    const other = (length - along) / cos;
    low = Math.max(low, Math.min(one, other));
    high = Math.min(high, Math.max(one, other));
  } else if (along < 0 || along > length) high = -Infinity;
  // Mostly it covers all that is left, and the ends need no look.
  if (low <= (starts[0] ?? 0) && high >= (ends[count - 1] ?? 0)) return take(low, high);
  let from = Infinity;
  let to = -Infinity;
  // The round ends.
  for (let end = 0; end < 2; end++) {
    const a = end === 0 ? along : along - length;
    const foot = -(a * cos + across * sin);
    const room = half * half - (a * a + across * across - foot * foot);
    if (room > 0) {
      const reach = Math.sqrt(room);
      if (foot - reach < from) from = foot - reach;
      if (foot + reach > to) to = foot + reach;
    }
    if (length === 0) break;
  }
  if (low < high) {
    if (low < from) from = low;
    if (high > to) to = high;
  }
  return from < to ? take(from, to) : 0;
}

/** Removes the interval from `from` to `to` from the uncovered parts, and returns the length that was removed. */
function take(from: number, to: number): number {
  let taken = 0;
  let kept = 0;
  const before = count;
  for (let i = 0; i < before; i++) {
    const start = starts[i] ?? 0;
    const end = ends[i] ?? 0;
    if (to <= start || from >= end) {
      starts[kept] = start;
      ends[kept++] = end;
      continue;
    }
    taken += Math.min(to, end) - Math.max(from, start);
    const hasLeft = from > start;
    if (hasLeft) {
      starts[kept] = start;
      ends[kept++] = from;
    }
    if (to >= end) continue;
    if (!hasLeft) {
      starts[kept] = to;
      ends[kept++] = end;
    } else {
      // Both sides remain: the piece lies within this part, so nothing else in the list is touched.
      makeRoom();
      starts.copyWithin(kept + 1, i + 1, before);
      ends.copyWithin(kept + 1, i + 1, before);
      starts[kept] = to;
      ends[kept] = end;
      count = kept + 1 + (before - i - 1);
      return taken;
    }
  }
  count = kept;
  return taken;
}

function makeRoom(): void {
  if (count + 1 < starts.length) return;
  const [moreStarts, moreEnds] = [new Float64Array(2 * starts.length), new Float64Array(2 * ends.length)];
  moreStarts.set(starts);
  moreEnds.set(ends);
  starts = moreStarts;
  ends = moreEnds;
}

/** Reflectance times length of the uncovered parts. */
function uncovered(px: number, py: number, ux: number, uy: number, under: Under): number {
  let sum = 0;
  for (let i = 0; i < count; i++) {
    const start = starts[i] ?? 0;
    const length = (ends[i] ?? 0) - start;
    if (typeof under === 'number') {
      sum += under * length;
      continue;
    }
    const looks = Math.ceil(length / PICTURE_STEP_MM);
    for (let look = 0; look < looks; look++) {
      const t = start + ((look + 0.5) * length) / looks;
      sum += (under.at(px + t * ux, py + t * uy) * length) / looks;
    }
  }
  return sum;
}
