import type { Vec } from '#core/geometry';
import type { Mark } from '../tools/tool';
import { axes, type Axis, type Frame, type Span } from './frames';
import { luresNear, type Lures } from './lures';
import { gapBetween, rowOf, widthOf, type Gap } from './row';

/** Tolerance of an alignment in mm: things are placed on whole mm. */
const SAME_MM = 0.6;

/** Gaps up to this, in mm, are not shown: the things touch. */
const GAP_MM = 0.5;

/** The guide lines of a thing: along its middle, or else its edges, where those of another thing lie in line with them. */
export function guidesOf(frame: Frame, lures: Lures): readonly Mark[] {
  return axes.flatMap(([axis, across]) => {
    const { min, mid, max } = frame[axis];
    const middle = guideAt(mid, 'middles', frame, lures, [axis, across]);
    if (middle) return [middle];
    const edges = [...new Set([min, max])].map((mm) => guideAt(mm, 'edges', frame, lures, [axis, across]));
    return edges.filter((guide) => guide !== null);
  });
}

function guideAt(
  atMm: number,
  what: 'edges' | 'middles',
  frame: Frame,
  lures: Lures,
  [axis, across]: readonly [Axis, Axis],
): Mark | null {
  let best: Frame | null = null;
  let bestMm = Infinity;
  for (const { of } of luresNear(lures[axis][what], atMm, SAME_MM)) {
    // The edge of the arena is seen without a line, and what stands in line comes before the arena's middle.
    const mm = of === lures.arena ? (what === 'edges' ? Infinity : Number.MAX_VALUE) : apart(of[across], frame[across]);
    if (mm >= bestMm) continue;
    best = of;
    bestMm = mm;
  }
  if (best === null) return null;
  const ends = [best[across].min, best[across].max, frame[across].min, frame[across].max];
  return {
    type: 'guide',
    from: placeAt(axis, atMm, Math.min(...ends)),
    to: placeAt(axis, atMm, Math.max(...ends)),
  };
}

const apart = (one: Span, two: Span): number => Math.max(0, one.min - two.max, two.min - one.max);

const placeAt = (axis: Axis, along: number, across: number): Vec =>
  axis === 'x' ? { x: along, y: across } : { x: across, y: along };

/**
 * The distances of a thing along each axis: all that are equal, else the one to the nearest thing, or to the edge of the
 * arena where nothing stands between.
 */
export function distancesOf(frame: Frame, { frames, arena }: Lures): readonly Mark[] {
  return axes.flatMap(([axis]) => {
    const equal = equalGaps(frame, frames, axis);
    const gaps = equal.length > 0 ? equal : nearestGap(frame, frames, arena, axis);
    return gaps.map((gap) => distance(gap, axis, equal.length > 0));
  });
}

const distance = ({ fromMm, toMm, acrossMm }: Gap, axis: Axis, equal: boolean): Mark => ({
  type: 'distance',
  from: placeAt(axis, fromMm, acrossMm),
  to: placeAt(axis, toMm, acrossMm),
  equal,
});

function equalGaps(frame: Frame, frames: readonly Frame[], axis: Axis): readonly Gap[] {
  const { before, after } = rowOf(frame, frames, axis);
  const [left, behindLeft] = before;
  const [right, behindRight] = after;
  const toLeft = left && gapBetween(left, frame, axis);
  const toRight = right && gapBetween(frame, right, axis);
  const pairs = [
    [toLeft, left && behindLeft && gapBetween(behindLeft, left, axis)],
    [toRight, right && behindRight && gapBetween(right, behindRight, axis)],
    [toLeft, toRight],
  ];
  const equal = new Set<Gap>();
  for (const [one, two] of pairs) {
    // An odd rest of the middle goes to one side.
    if (one && two && widthOf(one) > GAP_MM && Math.abs(widthOf(one) - widthOf(two)) <= 1) equal.add(one).add(two);
  }
  return [...equal];
}

function nearestGap(frame: Frame, frames: readonly Frame[], arena: Frame, axis: Axis): readonly Gap[] {
  const { before, after } = rowOf(frame, frames, axis);
  const [left] = before;
  const [right] = after;
  const toEdges = edgeGaps(frame, arena, axis);
  const gaps = [left ? gapBetween(left, frame, axis) : toEdges[0], right ? gapBetween(frame, right, axis) : toEdges[1]];
  const wide = gaps.filter((gap) => widthOf(gap) > GAP_MM);
  const [one, two] = wide;
  return one && two ? [widthOf(one) <= widthOf(two) ? one : two] : wide;
}

function edgeGaps(frame: Frame, arena: Frame, axis: Axis): readonly [Gap, Gap] {
  const across = axis === 'x' ? 'y' : 'x';
  const acrossMm = (frame[across].min + frame[across].max) / 2;
  const { min, max } = frame[axis];
  return [
    { fromMm: arena[axis].min, toMm: min, acrossMm },
    { fromMm: max, toMm: arena[axis].max, acrossMm },
  ];
}
