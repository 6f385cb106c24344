import type { Vec } from '#core/geometry';
import { stopsOf, withStops, type MoverStop } from '#scene/kinds/mover-way';
import { sceneLimits, type Mover, type Point } from '#scene/scene';
import { distanceMm, middleBetween, minus, plus, toPoint, toVec } from '../plane';
import { alongEighths, shortenedInto, wholeCentimetres } from '../snap';
import type { Drag, Handle } from '../tools/tool';

/** Length of the path of a mover that was put by a tap, in mm. Chosen: two cells of the arena's grid. */
const USUAL_TRACK_MM = 200;

/**
 * The handles of a mover's stops after the first, which is its place, and of new ones to be dragged out: in the middle
 * of each leg that is long enough, and beyond the last stop unless the way goes round.
 */
export function stopHandles(mover: Mover, reachMm: number): readonly Handle[] {
  const { id } = mover;
  const stops = stopsOf(mover).map(({ at }) => toVec(at));
  const handles = stops.map((at, index): Handle => ({ kind: 'point', id, at, index })).slice(1);
  const [first, last] = [stops[0], stops.at(-1)];
  if (!first || !last || stops.length < 2 || stops.length >= sceneLimits.stops) return handles;
  const legs = mover.loops && stops.length > 2 ? [...stops, first] : stops;
  const between = legs.slice(1).flatMap((to, leg): Handle[] => {
    const from = legs[leg] ?? to;
    if (distanceMm(from, to) < 6 * reachMm) return [];
    return [{ kind: 'add', id, at: middleBetween(from, to), index: leg + 1 }];
  });
  if (legs.length > stops.length) return [...handles, ...between];
  const ahead = beyond(stops.at(-2) ?? first, last, Math.min(...mover.size) / 2 + 2 * reachMm);
  return [...handles, ...between, { kind: 'add', id, at: ahead, index: stops.length }];
}

/** The place this far beyond the end of a leg, in its direction. */
function beyond(from: Vec, to: Vec, byMm: number): Vec {
  const length = distanceMm(from, to);
  if (length === 0) return { x: to.x + byMm, y: to.y };
  const step = minus(to, from);
  return plus(to, { x: (step.x * byMm) / length, y: (step.y * byMm) / length });
}

/**
 * A mover with a stop dragged to a place, or with a new one there. A stop that is dragged onto the one before or after
 * it is taken out of the way; a way keeps two.
 */
export function stopDragged(mover: Mover, { kind, index = 0 }: Handle, place: Vec, drag: Drag, arena: Point): Mover {
  const stops = stopsOf(mover);
  const before = stops[index - 1] ?? { at: mover.at, wait: 0 };
  const after = stops[kind === 'add' ? index : index + 1] ?? (mover.loops ? stops[0] : undefined);
  const others = [...stops.slice(0, index), ...stops.slice(kind === 'add' ? index : index + 1)];
  const isOn = [before, after].some((stop) => stop && distanceMm(toVec(stop.at), place) < drag.reachMm);
  if (isOn && others.length > 1) return withStops(mover, others);
  const at = stopPlace(place, before.at, arena, drag);
  const wait = kind === 'add' ? commonWait(stops) : (stops[index]?.wait ?? 0);
  return withStops(mover, [...others.slice(0, index), { at, wait }, ...others.slice(index)]);
}

/** The common waiting time of all stops; 0 if they differ. */
const commonWait = (stops: readonly MoverStop[]): number =>
  stops.every(({ wait }) => wait === stops[0]?.wait) ? (stops[0]?.wait ?? 0) : 0;

/** A mover without one of its stops; `null`: it is one of the last two. */
export function withoutStop(mover: Mover, index: number): Mover | null {
  const stops = stopsOf(mover);
  return stops.length < 3 ? null : withStops(mover, stops.toSpliced(index, 1));
}

/** A mover with one more stop, beside its last one (`turnedOff`); `null`: it has as many as there may be, or no way. */
export function withFurtherStop(mover: Mover, arena: Point): Mover | null {
  const stops = stopsOf(mover);
  const [before, last] = [stops.at(-2), stops.at(-1)];
  if (!before || !last || stops.length >= sceneLimits.stops) return null;
  return withStops(mover, [...stops, { at: turnedOff(before.at, last.at, arena), wait: commonWait(stops) }]);
}

/** To the left of the end of a leg, as far away as the leg is long; to the right where that leaves the arena. */
export function turnedOff(from: Point, to: Point, [width, height]: Point): Point {
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
  const left: Point = [to[0] - dy, to[1] + dx];
  const isInside = left[0] >= 0 && left[1] >= 0 && left[0] <= width && left[1] <= height;
  return isInside ? left : [to[0] + dy, to[1] - dx];
}

/** The place of a stop during its drag: in one of the eight directions from the one before, unless free; never on it. */
export function stopPlace(place: Vec, before: Point, arena: Point, { free, reachMm, lure }: Drag): Point {
  const start = toVec(before);
  const way = shortenedInto(start, free ? place : alongEighths(start, place), arena);
  const to = toPoint(free ? way : wholeCentimetres(start, way, reachMm, lure));
  return distanceMm(start, toVec(to)) < sceneLimits.blockMm.min ? usualStop(before, arena) : to;
}

/** The stop of a new way: to the right, or to the left where the right has no room for it. */
export function usualStop([x, y]: Point, [width]: Point): Point {
  const way = Math.min(USUAL_TRACK_MM, Math.max(width - x, x));
  return x + way <= width ? [x + way, y] : [x - way, y];
}
