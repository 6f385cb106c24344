import { lengthOf, type Axis, type Frame } from './frames';

/** The free space between two things along an axis, in mm. */
export interface Gap {
  readonly fromMm: number;
  readonly toMm: number;
  /** Position of the mark: the middle of the extent that both things share across the axis. */
  readonly acrossMm: number;
}

/** The neighbours of a thing along an axis: the nearest on each side, and the one behind it. */
export interface Row {
  readonly before: readonly Frame[];
  readonly after: readonly Frame[];
}

const other: Readonly<Record<Axis, Axis>> = { x: 'y', y: 'x' };

/** Two things are beside each other along an axis if they have more than an edge in common across it. */
const areBeside = (one: Frame, two: Frame, axis: Axis): boolean => {
  const across = other[axis];
  return one[across].min < two[across].max && two[across].min < one[across].max;
};

/** The nearest two things before and after a thing, in the row in which it is. */
export function rowOf(frame: Frame, frames: readonly Frame[], axis: Axis): Row {
  const beside = frames.filter((one) => areBeside(frame, one, axis));
  return { before: chain(frame, beside, axis, -1), after: chain(frame, beside, axis, 1) };
}

function chain(frame: Frame, beside: readonly Frame[], axis: Axis, way: 1 | -1): readonly Frame[] {
  const first = nextOf(frame, beside, axis, way);
  const second = first && nextOf(first, beside, axis, way);
  return [first, second].filter((one) => one !== null);
}

/** The nearest one that begins where this one ends, or beyond. */
function nextOf(from: Frame, beside: readonly Frame[], axis: Axis, way: 1 | -1): Frame | null {
  let best: Frame | null = null;
  let bestMm = Infinity;
  for (const one of beside) {
    const mm = one === from ? -1 : distanceAlong(from, one, axis, way);
    if (mm < 0 || mm >= bestMm) continue;
    best = one;
    bestMm = mm;
  }
  return best;
}

const distanceAlong = (from: Frame, to: Frame, axis: Axis, way: 1 | -1): number =>
  way === 1 ? to[axis].min - from[axis].max : from[axis].min - to[axis].max;

/** The gap between two things, the first of which comes first along the axis. */
export function gapBetween(one: Frame, two: Frame, axis: Axis): Gap {
  const across = other[axis];
  const low = Math.max(one[across].min, two[across].min);
  const high = Math.min(one[across].max, two[across].max);
  return { fromMm: one[axis].max, toMm: two[axis].min, acrossMm: (low + high) / 2 };
}

/** How wide a gap is, in mm. */
export const widthOf = ({ fromMm, toMm }: Gap): number => toMm - fromMm;

/** By how much a thing would have to go for equal distances: the gap behind a neighbour once more, or amid two of them. */
export function equalSteps(frame: Frame, frames: readonly Frame[], axis: Axis): readonly number[] {
  const { before, after } = rowOf(frame, frames, axis);
  const { min, max } = frame[axis];
  const [left, behindLeft] = before;
  const [right, behindRight] = after;
  const steps: number[] = [];
  if (left && behindLeft) steps.push(left[axis].max + distanceAlong(behindLeft, left, axis, 1) - min);
  if (right && behindRight) steps.push(right[axis].min - distanceAlong(right, behindRight, axis, 1) - max);
  if (left && right && lengthOf(frame[axis]) <= right[axis].min - left[axis].max)
    steps.push((left[axis].max + right[axis].min) / 2 - (min + max) / 2);
  return steps;
}
