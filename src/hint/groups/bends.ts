import type { Vec } from '#core/geometry';
import { exactAtan2, exactCos, exactSin } from '#core/exact-math';
import { lengthOf } from '#scene/outline';
import type { Scene, Stroke } from '#scene/scene';
import type { Moment } from '../watch/observed';

/** The ways of leaving a line at a bend: the robot went straight on, turned too late or too little, or turned too far. */
export const manners = ['straight', 'late', 'far'] as const;
export type Manner = (typeof manners)[number];

/** The place at which a robot left its line. `bend`: number of the bend from the start, from 1; 0: before the first. */
export interface Departure {
  readonly bend: number;
  /** `null`: it left on the straight after that bend. */
  readonly manner: Manner | null;
}

/** A bend of a line, in mm from the robot's start along its way. */
interface Bend {
  readonly from: number;
  readonly to: number;
  /** Positive: to the left. */
  readonly turnRad: number;
}

/** Distance of two places of a line that are looked at, in mm. */
const STEP_MM = 10;
/** A bend turns by this much over this length: a radius below half a metre. Chosen. */
const [WINDOW_STEPS, LEAST_RAD] = [8, 0.16];
/** A bend's least angle as a whole. Chosen: less is a line drawn by hand. */
const BEND_RAD = 0.6;
/** The robot is off its line at this distance, in mm; the bend is then behind it by at most this much. Chosen. */
const [OFF_MM, BEHIND_MM, BEFORE_MM] = [120, 180, 60];
/** Heading by which a robot has turned with a bend. Chosen. */
const TURNED_RAD = 0.2;

/**
 * The place at which a robot left the line on which it started; `null`: it did not start on one, or left it where that cannot be told.
 *
 * @param leftUs simulated time at which it was last on the line
 */
export function departureIn(moments: readonly Moment[], leftUs: number, course: Scene): Departure | null {
  const [start] = moments;
  const left = moments.findIndex(({ timeUs }) => timeUs >= leftUs);
  const line = start && lineAt(course, placeOf(start));
  if (start === undefined || left < 0 || line === null || line === undefined) return null;
  const closed = isClosed(line.places);
  const track = trackFrom(line.places, line.at, start.pose.headingRad, closed);
  const along = alongTrack(track, moments.slice(0, left + 1), closed);
  const way = along.at(-1) ?? 0;
  const bends = bendsOf(track);
  const bend = bends.findIndex(({ from, to }) => way >= from - BEFORE_MM && way <= to + BEHIND_MM);
  const found = bends[bend];
  if (found === undefined) return { bend: bends.filter(({ to }) => to < way).length, manner: null };
  const entered = moments[Math.max(0, along.findLastIndex((mm) => mm < found.from - BEFORE_MM / 2))]; // prettier-ignore
  const off = moments.slice(left).find((one) => lengthOf(...offsetOf(one, track, way)) > OFF_MM) ?? moments.at(-1);
  if (entered === undefined || off === undefined) return null;
  return { bend: bend + 1, manner: mannerOf(found, { entered, off, track, way }) };
}

function mannerOf(
  { turnRad }: Bend,
  {
    entered,
    off,
    track,
    way,
  }: { readonly entered: Moment; readonly off: Moment; readonly track: readonly Vec[]; readonly way: number },
): Manner {
  const heading = headingAt(track, Math.round(way / STEP_MM));
  const [x, y] = offsetOf(off, track, way);
  const across = y * exactCos(heading) - x * exactSin(heading);
  if (across * turnRad > 0) return 'far';
  const turned = (off.pose.headingRad - entered.pose.headingRad) * Math.sign(turnRad);
  return turned < TURNED_RAD ? 'straight' : 'late';
}

const placeOf = ({ pose }: Moment): Vec => ({ x: pose.xMm, y: pose.yMm });

const offsetOf = (moment: Moment, track: readonly Vec[], way: number): [x: number, y: number] => {
  const { x, y } = track[Math.round(way / STEP_MM)] ?? { x: 0, y: 0 };
  return [moment.pose.xMm - x, moment.pose.yMm - y];
};

/** The line under a place, as places `STEP_MM` apart, and the index of the nearest one. */
function lineAt({ objects }: Scene, place: Vec): { readonly places: readonly Vec[]; readonly at: number } | null {
  for (const { points, width } of objects.filter((one): one is Stroke => one.type === 'stroke')) {
    const places = evenly(points);
    const at = nearest(places, place, 0, places.length);
    const { x, y } = places[at] ?? { x: Infinity, y: Infinity };
    if (lengthOf(x - place.x, y - place.y) <= width / 2 + OFF_MM / 2) return { places, at };
  }
  return null;
}

function evenly(points: Stroke['points']): readonly Vec[] {
  const places: Vec[] = [];
  let rest = 0;
  for (const [index, [toX, toY]] of points.entries()) {
    const [x, y] = points[index - 1] ?? [toX, toY];
    const length = lengthOf(toX - x, toY - y);
    for (; rest < length; rest += STEP_MM)
      places.push({ x: x + ((toX - x) * rest) / length, y: y + ((toY - y) * rest) / length });
    rest -= length;
  }
  return places;
}

function isClosed(places: readonly Vec[]): boolean {
  const [first, last] = [places[0], places.at(-1)];
  return first !== undefined && last !== undefined && lengthOf(first.x - last.x, first.y - last.y) < 3 * STEP_MM;
}

/** The places of a line from the robot's start on, in its direction; of a closed line once round. */
function trackFrom(places: readonly Vec[], at: number, headingRad: number, closed: boolean): readonly Vec[] {
  const [before, after] = [places[Math.max(0, at - 2)], places[Math.min(places.length - 1, at + 2)]];
  const ahead =
    ((after?.x ?? 0) - (before?.x ?? 0)) * exactCos(headingRad) +
    ((after?.y ?? 0) - (before?.y ?? 0)) * exactSin(headingRad);
  const [row, from] = ahead >= 0 ? [places, at] : [places.toReversed(), places.length - 1 - at];
  return closed ? [...row.slice(from), ...row.slice(0, from)] : row.slice(from);
}

/** For each moment how far along the track the robot is, in mm; a robot beside it is where it was nearest. */
function alongTrack(track: readonly Vec[], moments: readonly Moment[], closed: boolean): readonly number[] {
  let at = 0;
  return moments.map((moment) => {
    // Of a line that crosses itself the piece nearby is meant; a lap ends where it began.
    at = nearest(track, placeOf(moment), Math.max(0, at - NEAR_STEPS), at + NEAR_STEPS);
    if (closed && at >= track.length - 1) at = 0;
    return at * STEP_MM;
  });
}

/** Chosen: a robot at full speed drives two of these steps in a moment. */
const NEAR_STEPS = 12;

function nearest(places: readonly Vec[], { x, y }: Vec, from: number, to: number): number {
  let [best, least] = [from, Infinity];
  for (let index = from; index < Math.min(to, places.length); index += 1) {
    const place = places[index];
    if (place === undefined) continue;
    const squared = (place.x - x) * (place.x - x) + (place.y - y) * (place.y - y);
    if (squared < least) [best, least] = [index, squared];
  }
  return best;
}

/** The direction of the track at a place, over a window round it. */
function headingAt(track: readonly Vec[], index: number): number {
  const [from, to] = [track[Math.max(0, index - WINDOW_STEPS / 2)], track[Math.min(track.length - 1, index + WINDOW_STEPS / 2)]]; // prettier-ignore
  return exactAtan2((to?.y ?? 0) - (from?.y ?? 0), (to?.x ?? 0) - (from?.x ?? 0));
}

function bendsOf(track: readonly Vec[]): readonly Bend[] {
  const bends: Bend[] = [];
  let open: { from: number; turnRad: number } | null = null;
  for (let index = 0; index <= track.length; index += 1) {
    const over = index + WINDOW_STEPS < track.length ? wrapped(headingAt(track, index + WINDOW_STEPS / 2) - headingAt(track, index - WINDOW_STEPS / 2)) : 0; // prettier-ignore
    const turns = Math.abs(over) >= LEAST_RAD;
    if (open !== null && (!turns || over * open.turnRad < 0)) {
      if (Math.abs(open.turnRad) >= BEND_RAD)
        bends.push({ from: open.from * STEP_MM, to: index * STEP_MM, turnRad: open.turnRad });
      open = null;
    }
    if (turns) {
      open ??= { from: index, turnRad: 0 };
      open.turnRad += over / WINDOW_STEPS;
    }
  }
  return bends;
}

const wrapped = (rad: number): number => (rad > Math.PI ? rad - 2 * Math.PI : rad < -Math.PI ? rad + 2 * Math.PI : rad);
