import type { Vec } from '#core/geometry';
import { isSame } from '#core/same';
import type { Point, Stroke } from '#scene/scene';
import { thinned } from '#scene/simplify';
import { distanceMm, minus, plus, toPoint, toVec } from '../plane';

/**
 * A line as it is bent by hand. Of a line with many points only those are taken hold of that make its shape; the others
 * go along.
 */
export interface BentLine {
  /** The points; of a closed line without the repeated first one. */
  readonly places: readonly Vec[];
  readonly isClosed: boolean;
  /** Indices of the places that can be taken hold of, in order. */
  readonly controls: readonly number[];
}

/** How far the shape between two controls may be from straight, in mm, before there is one more. Chosen: looks good. */
const SHAPE_MM = 4;

/** Maximum number of draggable points. Chosen: more cannot be told apart on a tablet. */
const MOST = 40;

/** The line of a stroke with its controls: as few points as make its shape. */
export function bentLine({ points }: Pick<Stroke, 'points'>): BentLine {
  const path = points.map(toVec);
  const [first, last] = [points[0], points[points.length - 1]];
  const isClosed = points.length > 3 && isSame(first, last);
  const places = isClosed ? path.slice(0, -1) : path;
  return { places, isClosed, controls: controlsOf(path).filter((index) => index < places.length) };
}

function controlsOf(path: readonly Vec[]): readonly number[] {
  for (let toleranceMm = SHAPE_MM; ; toleranceMm *= 2) {
    const kept = new Set(thinned(path, toleranceMm));
    if (kept.size > MOST) continue;
    return path.flatMap((place, index) => (kept.has(place) ? [index] : []));
  }
}

/** The places of a line's controls. */
export const controlPlaces = ({ places, controls }: BentLine): readonly Vec[] =>
  controls.flatMap((index) => places[index] ?? []);

/** The controls before and after one; `null`: the line ends there. */
export function neighbours({ controls, isClosed }: BentLine, at: number): readonly [number | null, number | null] {
  const count = controls.length;
  const other = (to: number): number | null =>
    to >= 0 && to < count ? to : isClosed && count > 1 ? (to + count) % count : null;
  return [other(at - 1), other(at + 1)];
}

/** The places in the middle of the parts between two controls, where a new one can be drawn out of the line. */
export function partMiddles(line: BentLine): readonly { readonly after: number; readonly at: Vec }[] {
  const { controls, isClosed } = line;
  const parts = isClosed ? controls.length : controls.length - 1;
  return Array.from({ length: Math.max(0, parts) }, (_, after) => ({ after, at: middleOfPart(line, after).at }));
}

/** The indices of the places after a control up to the next one, that one included. */
function partAfter({ places, controls, isClosed }: BentLine, after: number): readonly number[] {
  const from = controls[after] ?? 0;
  const to = controls[after + 1] ?? (isClosed ? places.length + (controls[0] ?? 0) : places.length - 1);
  return Array.from({ length: Math.max(0, to - from) }, (_, index) => (from + index + 1) % places.length);
}

/** The middle of a part: one of its places that is near to it, or a new place before one. */
interface Middle {
  readonly at: Vec;
  readonly index: number;
  readonly isThere: boolean;
}

function middleOfPart(line: BentLine, after: number): Middle {
  const { places, controls } = line;
  const start = controls[after] ?? 0;
  let before = places[start] ?? ORIGIN;
  const pieces = partAfter(line, after).map((index) => {
    const piece = { index, from: before, to: places[index] ?? before };
    before = piece.to;
    return piece;
  });
  const half = pieces.reduce((sum, { from, to }) => sum + distanceMm(from, to), 0) / 2;
  let walked = 0;
  for (const { index, from, to } of pieces) {
    const mm = distanceMm(from, to);
    walked += mm;
    if (walked < half || mm === 0) continue;
    const share = 1 - (walked - half) / mm;
    const at = { x: from.x + (to.x - from.x) * share, y: from.y + (to.y - from.y) * share };
    const isInner = index !== pieces[pieces.length - 1]?.index;
    // A new place right beside one would bend the line sharply once both are in whole mm.
    return isInner && distanceMm(at, to) <= half / 2 ? { at: to, index, isThere: true } : { at, index, isThere: false };
  }
  return { at: before, index: start, isThere: true };
}

const ORIGIN: Vec = { x: 0, y: 0 };

/** A line with one more control in the middle of the part after one. Its shape stays. */
export function withNewControl(line: BentLine, after: number): BentLine {
  const { at, index, isThere } = middleOfPart(line, after);
  const head = line.controls.slice(0, after + 1);
  const tail = line.controls.slice(after + 1);
  if (isThere) return { ...line, controls: [...head, index, ...tail] };
  // After the last place of a closed line comes its first again.
  const before = index === 0 ? line.places.length : index;
  return {
    ...line,
    places: [...line.places.slice(0, before), at, ...line.places.slice(before)],
    controls: [...head, before, ...tail.map((control) => (control >= before ? control + 1 : control))],
  };
}

/** A line with a control at another place. What lies between its neighbours goes along, the less the further away. */
export function withControlAt(given: BentLine, at: number, to: Vec): BentLine {
  const isSharp = isCorner(given, given.controls[at] ?? 0) || isAngular(given, at);
  const line = isSharp ? given : denser(given, at);
  const { places, controls } = line;
  const index = controls[at];
  const from = index === undefined ? undefined : places[index];
  if (index === undefined || !from) return line;
  const step = minus(to, from);
  const weights = new Map([[index, 1]]);
  const [before, after] = neighbours(line, at);
  const ease = isSharp ? (share: number): number => share : smoothly;
  if (before !== null) weigh(line, before, ease, false, weights);
  if (after !== null) weigh(line, at, ease, true, weights);
  return {
    ...line,
    places: places.map((place, one) => {
      const weight = weights.get(one) ?? 0;
      return weight === 0 ? place : plus(place, { x: step.x * weight, y: step.y * weight });
    }),
  };
}

/** True if a line is drawn from corner to corner around a control: there is nothing between it and its neighbours. */
function isAngular(line: BentLine, at: number): boolean {
  const [before] = neighbours(line, at);
  return (before === null || partAfter(line, before).length < 2) && partAfter(line, at).length < 2;
}

/** Distance of the places in a part that is bent, in mm. Chosen: a bend by a finger's width looks round. */
const DENSE_MM = 8;

/** A line with places close to each other on both sides of a control. */
function denser(line: BentLine, at: number): BentLine {
  const [before, after] = neighbours(line, at);
  const ends = new Set([
    ...(before === null ? [] : partAfter(line, before)),
    ...(after === null ? [] : partAfter(line, at)),
  ]);
  const places: Vec[] = [];
  const indices = line.places.map((place, index) => {
    const from = line.places[index - 1] ?? line.places[line.places.length - 1] ?? place;
    const pieces = ends.has(index) ? Math.ceil(distanceMm(from, place) / DENSE_MM) : 1;
    for (let piece = 1; piece < pieces; piece += 1)
      places.push(plus(from, { x: ((place.x - from.x) * piece) / pieces, y: ((place.y - from.y) * piece) / pieces }));
    return places.push(place) - 1;
  });
  return { ...line, places, controls: line.controls.flatMap((control) => indices[control] ?? []) };
}

/** Rises from 0 to 1 without a kink at either end. */
const smoothly = (share: number): number => share * share * (3 - 2 * share);

/** Notes how far the inner places of a part go along with the control at its beginning, or at its end: 0 … 1. */
function weigh(
  line: BentLine,
  after: number,
  ease: (share: number) => number,
  isFromStart: boolean,
  weights: Map<number, number>,
): void {
  const way = [line.controls[after] ?? 0, ...partAfter(line, after)];
  const walked: number[] = [0];
  way.slice(1).forEach((to, index) => {
    const [start, end] = [line.places[way[index] ?? to], line.places[to]];
    walked.push((walked[index] ?? 0) + (start && end ? distanceMm(start, end) : 0));
  });
  const whole = walked[walked.length - 1] ?? 0;
  if (whole === 0) return;
  for (const [index, mm] of walked.entries()) {
    const place = way[index];
    if (index === 0 || index === way.length - 1 || place === undefined) continue;
    weights.set(place, ease(isFromStart ? 1 - mm / whole : mm / whole));
  }
}

/** A sharper bend than this is a corner, on both sides of which a line is straight: the cosine of 30°. */
const CORNER_COS = 0.866;

function isCorner({ places, isClosed }: BentLine, index: number): boolean {
  const count = places.length;
  const at = (to: number): Vec | undefined => (isClosed ? places[(to + count) % count] : places[to]);
  const [before, place, after] = [at(index - 1), at(index), at(index + 1)];
  if (!before || !place || !after) return true;
  const [one, other] = [minus(place, before), minus(after, place)];
  const lengths = distanceMm(before, place) * distanceMm(place, after);
  return one.x * other.x + one.y * other.y < CORNER_COS * lengths;
}

/** A line without a control: what was between its neighbours is straight. `null`: too little would be left. */
export function withoutControl(line: BentLine, at: number): BentLine | null {
  const { places, controls, isClosed } = line;
  if (controls.length <= (isClosed ? 3 : 2)) return null;
  const index = controls[at] ?? 0;
  const [before, after] = neighbours(line, at);
  const gone = new Set([index]);
  if (before !== null) for (const one of partAfter(line, before)) gone.add(one);
  if (after !== null) for (const one of partAfter(line, at).slice(0, -1)) gone.add(one);
  const left = places.map((_, one) => one).filter((one) => !gone.has(one));
  return {
    ...line,
    places: left.flatMap((one) => places[one] ?? []),
    controls: controls.filter((_, one) => one !== at).map((control) => left.indexOf(control)),
  };
}

/** Places are left out that lie no further than this from a straight line, in mm: rounding moves them further. */
const FLAT_MM = 0.2;

/** The points of a line in whole mm, one after the other never the same. */
export function pointsOfBent({ places, isClosed }: BentLine): readonly Point[] {
  const points: Point[] = [];
  for (const place of thinned(isClosed ? [...places, ...places.slice(0, 1)] : places, FLAT_MM)) {
    const point = toPoint(place);
    const last = points[points.length - 1];
    if (!last || !isSame(last, point)) points.push(point);
  }
  return points;
}
