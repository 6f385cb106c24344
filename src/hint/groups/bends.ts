import type { Vec } from '#core/geometry';
import { exactAtan2, exactCos, exactSin } from '#core/exact-math';
import { lengthOf } from '#scene/outline';
import type { Scene, Stroke } from '#scene/scene';
import { shapeOutline } from '#scene/shape/shape';
import { middleOf } from '#check/run/line-watch';
import type { Moment } from '../watch/observed';

/** The ways of leaving a line at a bend: the robot went straight on, turned too late or too little, or turned too far. */
export const manners = ['straight', 'late', 'far'] as const;
export type Manner = (typeof manners)[number];

/** The place at which a robot left its line. `bend`: number of the bend from the start, from 1; 0: before the first. */
export interface Departure {
  /** Simulated seconds at which it was last on the line. */
  readonly atS: number;
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
/** The robot is on its line up to this distance from its edge, and off from the other on, in mm. Chosen: sensors lie before the axle. */
const [ON_MM, OFF_MM] = [30, 60];
/** A bend reaches so far behind its end for a robot that swings out. Chosen. */
const [BEFORE_MM, BEHIND_MM] = [20, 180];
/** Heading by which a robot has turned with a bend. Chosen. */
const TURNED_RAD = 0.2;
/** A robot that has driven less along its line has not followed it, in mm. Chosen: half a robot. */
const FOLLOWED_MM = 50;

/** The line on which a robot started and that leads to all places of the course, seen along its way. */
export class Track {
  private readonly bends: readonly Bend[];

  private constructor(
    private readonly places: readonly Vec[],
    private readonly halfMm: number,
    private readonly closed: boolean,
  ) {
    this.bends = bendsOf(places);
  }

  /** The track of a robot that begins like this; `null`: it does not start on a line, or that leads elsewhere. */
  static from({ objects }: Scene, start: Moment): Track | null {
    const place = placeOf(start);
    const goals = objects.flatMap((one) =>
      one.type === 'checkpoint' || one.type === 'target' ? [middleOf(shapeOutline(one))] : [],
    );
    for (const { points, width } of objects.filter((one): one is Stroke => one.type === 'stroke')) {
      const places = evenly(points);
      const reaches = (goal: Vec, mm: number): boolean => distance(places, goal) <= width / 2 + mm;
      if (goals.length === 0 || !reaches(place, OFF_MM) || !goals.every((goal) => reaches(goal, ON_MM))) continue;
      const closed = isClosed(places);
      const track = trackFrom(places, nearest(places, place, 0, places.length), start.pose.headingRad, closed);
      return new Track(track, width / 2, closed);
    }
    return null;
  }

  /** Number of the bend at a place, from 1; `null`: there is none. */
  bendAt(place: Vec): number | null {
    const at = nearest(this.places, place, 0, this.places.length);
    return distance(this.places, place) > BEHIND_MM ? null : this.bendOn(at * STEP_MM);
  }

  /** The place at which the robot left the line for good; `null`: it did not, or had not followed it before. */
  departure(moments: readonly Moment[]): Departure | null {
    const isOn = (moment: Moment): boolean => distance(this.places, placeOf(moment)) <= this.halfMm + ON_MM;
    const left = moments.findLastIndex(isOn);
    const off = moments.slice(left).find((one) => distance(this.places, placeOf(one)) > this.halfMm + OFF_MM);
    const along = this.along(moments.slice(0, left + 1));
    const way = along.at(-1) ?? 0;
    const timeUs = moments[left]?.timeUs;
    if (off === undefined || timeUs === undefined || Math.max(...along) < FOLLOWED_MM) return null;
    const atS = Math.round(timeUs / 100_000) / 10;
    const number = this.bendOn(way);
    const bend = this.bends[(number ?? 0) - 1];
    if (number === null || bend === undefined)
      return { atS, bend: this.bends.filter(({ to }) => to < way).length, manner: null };
    const entered =
      moments[
        Math.max(
          0,
          along.findLastIndex((mm) => mm < bend.from),
        )
      ];
    return { atS, bend: number, manner: entered === undefined ? null : this.manner(bend, { entered, off, way }) };
  }

  private bendOn(way: number): number | null {
    const found = this.bends.findLastIndex(({ from }) => way >= from - BEFORE_MM);
    return way <= (this.bends[found]?.to ?? -Infinity) + BEHIND_MM ? found + 1 : null;
  }

  private manner(
    { turnRad }: Bend,
    { entered, off, way }: { readonly entered: Moment; readonly off: Moment; readonly way: number },
  ): Manner {
    const index = Math.round(way / STEP_MM);
    const heading = headingAt(this.places, index);
    const { x, y } = this.places[index] ?? { x: 0, y: 0 };
    const across = (off.pose.yMm - y) * exactCos(heading) - (off.pose.xMm - x) * exactSin(heading);
    if (across * turnRad > 0) return 'far';
    const turned = (off.pose.headingRad - entered.pose.headingRad) * Math.sign(turnRad);
    return turned < TURNED_RAD ? 'straight' : 'late';
  }

  /** For each moment how far along the track the robot is, in mm. Of a line that crosses itself the piece nearby is meant. */
  private along(moments: readonly Moment[]): readonly number[] {
    const { places, closed } = this;
    let at = 0;
    return moments.map((moment) => {
      const place = placeOf(moment);
      at = nearest(places, place, Math.max(0, at - NEAR_STEPS), at + NEAR_STEPS);
      const { x, y } = places[at] ?? place;
      if (lengthOf(x - place.x, y - place.y) > BEHIND_MM) at = nearest(places, place, 0, places.length);
      if (closed && at >= places.length - 1) at = 0;
      return at * STEP_MM;
    });
  }
}

const placeOf = ({ pose }: Moment): Vec => ({ x: pose.xMm, y: pose.yMm });

/** Chosen: a robot at full speed drives two of these steps in a moment. */
const NEAR_STEPS = 12;

function distance(places: readonly Vec[], place: Vec): number {
  const { x, y } = places[nearest(places, place, 0, places.length)] ?? { x: Infinity, y: Infinity };
  return lengthOf(x - place.x, y - place.y);
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
