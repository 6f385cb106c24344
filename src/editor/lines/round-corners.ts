// The radius of a line's corners. A course knows the points of a line alone, so a round corner is found again by its shape.
import { exactAtan2, exactTan } from '#core/exact-math';
import type { Vec } from '#core/geometry';
import { isSame } from '#core/same';
import type { Point, Stroke } from '#scene/scene';
import { distanceMm, middleBetween, minus, plus, toPoint, toVec } from '../plane';
import { arc } from './curves';
import { inWholeMm } from './whole-mm';

/** The place at which two straight sides of a line meet, or would meet without the arc between them. Another point turns by 0. */
interface Corner {
  readonly at: Vec;
  /** Counter-clockwise, in rad. */
  readonly turn: number;
  /** 0: sharp. */
  readonly radiusMm: number;
}

interface Corners {
  readonly corners: readonly Corner[];
  readonly isClosed: boolean;
}

/** The radius of the first corner, 0 for a sharp one, and the largest that all corners can have; in whole mm. */
export interface CornerRadius {
  readonly mm: number;
  readonly mostMm: number;
}

const RAD = Math.PI / 180;

/** A line turns at least by so much at a corner, sharp or round. */
const SHARP = 30 * RAD;
const LEAST_ARC = 20 * RAD;
/** Sides that turn back have no corner that could be round. */
const MOST_TURN = 170 * RAD;
/** Points in whole mm tremble: in an arc the line has turned back by at most so much. */
const TREMBLE = 70 * RAD;

/** How far points and pieces of a round corner may be from its circle, in mm: whole mm, and what `inWholeMm` allows. */
const APART_MM = 0.75;
/** By how much its ends may differ in their distance from where the sides would meet, in mm. */
const UNEVEN_MM = 2;

/** Points that one arc has at most, and a line whose corners are looked for: a longer one is drawn by hand. */
const MOST_IN_ARC = 60;
const MOST_POINTS = 400;
/** Corners are not worth a number if their largest radius is less, in mm. */
const LEAST_MOST_MM = 5;

/** The radius of a line's corners; `null` if it has none, or sides too short for any. */
export function cornerRadius({ points }: Pick<Stroke, 'points'>): CornerRadius | null {
  const found = cornersOf(points);
  const first = found?.corners.find(({ turn }) => turn !== 0);
  if (!found || !first) return null;
  const mostMm = Math.max(first.radiusMm, largestMm(found));
  return mostMm < LEAST_MOST_MM ? null : { mm: first.radiusMm, mostMm };
}

/** A line with this radius at each of its corners, in mm; 0 makes them sharp. Its other points stay. */
export function withCornerRadius(stroke: Stroke, radiusMm: number): Stroke {
  const found = cornersOf(stroke.points);
  if (!found) return stroke;
  const points: Point[] = [];
  found.corners.forEach((corner, index) => {
    for (const point of roundedAt(corner, neighboursOf(found, index), radiusMm)) {
      const last = points[points.length - 1];
      if (!last || !isSame(last, point)) points.push(point);
    }
  });
  const [first] = points;
  const last = points[points.length - 1];
  return { ...stroke, points: found.isClosed && first && last && !isSame(first, last) ? [...points, first] : points };
}

function roundedAt(corner: Corner, [before, after]: readonly [Vec, Vec], radiusMm: number): readonly Point[] {
  if (corner.turn === 0 || radiusMm === 0) return [toPoint(corner.at)];
  const { centre, from } = circleIn(corner.at, unit(before, corner.at), corner.turn, radiusMm);
  const start = minus(from, centre);
  const end = plus(corner.at, times(unit(corner.at, after), tangentMm(corner.turn, radiusMm)));
  return [...inWholeMm(arc(centre, radiusMm, exactAtan2(start.y, start.x), corner.turn)).slice(0, -1), toPoint(end)];
}

/** Length of a side that a corner takes, in mm. */
const tangentMm = (turn: number, radiusMm: number): number => radiusMm * exactTan(Math.abs(turn) / 2);

/** The circle in a corner that touches both of its sides, and where it touches the first, which comes along `ahead`. */
function circleIn(at: Vec, ahead: Vec, turn: number, radiusMm: number): { readonly centre: Vec; readonly from: Vec } {
  const from = plus(at, times(ahead, -tangentMm(turn, radiusMm)));
  const aside = turn > 0 ? { x: -ahead.y, y: ahead.x } : { x: ahead.y, y: -ahead.x };
  return { centre: plus(from, times(aside, radiusMm)), from };
}

/** The places before and after a corner; the ends of an open line stand for what is not there. */
function neighboursOf({ corners, isClosed }: Corners, index: number): readonly [Vec, Vec] {
  const at = (to: number): Vec => {
    const place = isClosed ? (to + corners.length) % corners.length : Math.min(Math.max(to, 0), corners.length - 1);
    return corners[place]?.at ?? { x: 0, y: 0 };
  };
  return [at(index - 1), at(index + 1)];
}

function largestMm(found: Corners): number {
  const { corners, isClosed } = found;
  let most = Infinity;
  corners.forEach(({ at, turn }, index) => {
    const next = corners[index + 1] ?? (isClosed ? corners[0] : undefined);
    if (!next) return;
    const taken = tangentMm(turn, 1) + tangentMm(next.turn, 1);
    if (taken > 0) most = Math.min(most, distanceMm(at, next.at) / taken);
  });
  return most === Infinity ? 0 : Math.floor(most);
}

/** The corners and other points of a line; `null` for one of very many points, or of one piece. */
function cornersOf(points: readonly Point[]): Corners | null {
  if (points.length < 3 || points.length > MOST_POINTS) return null;
  const [first, last] = [points[0], points[points.length - 1]];
  const isClosed = points.length > 3 && isSame(first, last);
  const places = isClosed ? fromLongest(points.slice(0, -1).map(toVec)) : points.map(toVec);
  const way: Way = { places, isClosed };
  const corners: Corner[] = [];
  for (let index = 0; index < places.length;) {
    const round = roundFrom(way, index);
    corners.push(round?.corner ?? pointAt(way, index));
    index = (round?.to ?? index) + 1;
  }
  return { corners, isClosed };
}

interface Way {
  readonly places: readonly Vec[];
  readonly isClosed: boolean;
}

/** The places of a closed line, beginning after its longest piece: no arc goes through that. */
function fromLongest(places: readonly Vec[]): readonly Vec[] {
  let [best, longest] = [0, -1];
  places.forEach((place, index) => {
    const mm = distanceMm(places[(index + places.length - 1) % places.length] ?? place, place);
    if (mm > longest) [best, longest] = [index, mm];
  });
  return [...places.slice(best), ...places.slice(0, best)];
}

function placeAt({ places, isClosed }: Way, index: number): Vec | undefined {
  return isClosed ? places[(index + places.length) % places.length] : places[index];
}

function pointAt(way: Way, index: number): Corner {
  const turn = turnAt(way, index);
  const size = Math.abs(turn);
  const at = way.places[index] ?? { x: 0, y: 0 };
  return { at, turn: size >= SHARP && size <= MOST_TURN ? turn : 0, radiusMm: 0 };
}

/** By how much a line turns at a place; 0 at its ends. */
function turnAt(way: Way, index: number): number {
  const [before, at, after] = [placeAt(way, index - 1), placeAt(way, index), placeAt(way, index + 1)];
  return before && at && after ? turnBetween(minus(at, before), minus(after, at)) : 0;
}

const turnBetween = (one: Vec, other: Vec): number =>
  exactAtan2(one.x * other.y - one.y * other.x, one.x * other.x + one.y * other.y);

/** The round corner that begins at a place, and its last place: the longest one. */
function roundFrom(way: Way, from: number): { readonly corner: Corner; readonly to: number } | null {
  let found: { readonly corner: Corner; readonly to: number } | null = null;
  let [least, turned, most] = [0, 0, 0];
  for (let to = from; to < Math.min(way.places.length, from + MOST_IN_ARC); to++) {
    turned += turnAt(way, to);
    least = Math.min(least, turned);
    most = Math.max(most, turned);
    if (most - turned > TREMBLE && turned - least > TREMBLE) break;
    if (Math.abs(turned) > MOST_TURN + TREMBLE) break;
    const corner = to - from < 2 || Math.abs(turned) < LEAST_ARC ? null : roundCorner(way, from, to);
    if (corner) found = { corner, to };
  }
  return found;
}

/** The corner between the sides before and after some places, if these lie on an arc that touches both. */
function roundCorner(way: Way, from: number, to: number): Corner | null {
  const [before, start, end, after] = [from - 1, from, to, to + 1].map((index) => placeAt(way, index));
  if (!before || !start || !end || !after) return null;
  const [ahead, onward] = [unit(before, start), unit(end, after)];
  const turn = turnBetween(ahead, onward);
  const at = Math.abs(turn) > MOST_TURN ? null : meeting(start, ahead, end, onward);
  if (at === null) return null;
  const [one, other] = [along(minus(at, start), ahead), along(minus(end, at), onward)];
  if (one <= 0 || other <= 0 || Math.abs(one - other) > UNEVEN_MM) return null;
  const places = Array.from({ length: to - from + 1 }, (_, index) => placeAt(way, from + index) ?? at);
  const about = (one + other) / 2 / tangentMm(turn, 1);
  // The roundest number that fits: the points are in whole mm.
  for (const step of [10, 5, 1]) {
    const radiusMm = Math.round(about / step) * step;
    const { centre } = circleIn(at, ahead, turn, radiusMm);
    const fits = (place: Vec): boolean => Math.abs(distanceMm(place, centre) - radiusMm) <= APART_MM;
    const lies = (place: Vec, index: number): boolean => fits(middleBetween(places[index - 1] ?? place, place));
    if (radiusMm > 0 && places.every((place, index) => fits(place) && lies(place, index)))
      return { at, turn, radiusMm };
  }
  return null;
}

/** The place at which two lines meet, each through a place in a direction; `null`: nowhere. */
function meeting(a: Vec, ahead: Vec, b: Vec, onward: Vec): Vec | null {
  const cross = ahead.x * onward.y - ahead.y * onward.x;
  if (cross === 0) return null;
  const to = minus(b, a);
  return plus(a, times(ahead, (to.x * onward.y - to.y * onward.x) / cross));
}

const times = ({ x, y }: Vec, factor: number): Vec => ({ x: x * factor, y: y * factor });
const along = (a: Vec, b: Vec): number => a.x * b.x + a.y * b.y;

function unit(from: Vec, to: Vec): Vec {
  const mm = distanceMm(from, to);
  return mm === 0 ? { x: 0, y: 0 } : times(minus(to, from), 1 / mm);
}
