import type { Vec } from '#core/geometry';
import { exactCos, exactSin } from '#core/exact-math';
import { distanceToEdge } from '#scene/outline';
import type { Scene, Zone } from '#scene/scene';
import { shapeOutline } from '#scene/shape/shape';
import { zoneHolds } from '#scene/kinds/zone';
import type { Moment, Observed } from '../watch/observed';

/** A robot passed by the place that was next. */
export interface PassedBy {
  readonly atS: number;
  readonly side: 'left' | 'right';
  /** How many turns on the spot it had made before; 0: none, or too many to count. */
  readonly turns: number;
  /** Number of the checkpoint; `null`: it was the target. */
  readonly checkpoint: number | null;
}

/** Simulated time for which the motors stay as they are if nothing answers. Chosen: many rounds of a loop. */
const ANSWER_US = 500_000;

/** From when on all line sensors saw light ground as the robot left its line; `null`: one saw the dark again, or there is none. */
export function brightAt(
  moments: readonly Moment[],
  leftUs: number,
): { readonly atUs: number; readonly answers: boolean } | null {
  const isBright = ({ bright }: Moment): boolean => bright.length > 0 && bright.every(Boolean);
  const left = moments.findIndex(({ timeUs }) => timeUs >= leftUs);
  if (left < 0) return null;
  const lastDark = moments.slice(0, left + 1).findLastIndex((one) => !isBright(one));
  const onwards = moments.slice(lastDark + 1, lastDark + 1 + ANSWER_US / 20_000);
  const [first] = onwards;
  if (first === undefined || !onwards.every(isBright)) return null;
  const answers = onwards.some(({ duty }) => duty.left !== first.duty.left || duty.right !== first.duty.right);
  return { atUs: first.timeUs, answers };
}

/** Turning on the spot: the wheels turn against each other. */
const isTurning = ({ duty }: Moment): boolean => duty.left * duty.right < 0;

/** The least angle of a turn. Chosen: less is steering. */
const TURN_RAD = 0.35;

/** A turn on the spot: the places in the moments at which it began and was over. */
interface Turn {
  readonly from: number;
  readonly to: number;
}

function turnsIn(moments: readonly Moment[]): readonly Turn[] {
  const turns: Turn[] = [];
  let from: number | null = null;
  for (const [place, moment] of moments.entries()) {
    if (isTurning(moment)) from ??= place;
    else if (from !== null) {
      const turned = moment.pose.headingRad - (moments[from]?.pose.headingRad ?? 0);
      if (Math.abs(turned) >= TURN_RAD) turns.push({ from, to: place });
      from = null;
    }
  }
  return turns;
}

/** Chosen: nobody counts further. */
const MOST_TURNS = 8;

/** Way past a place after which the robot has passed it, and the farthest at which it is passed by, in mm. Chosen. */
const [BEYOND_MM, BESIDE_MM] = [40, 250];

/** The parts of a run that say whether a place was passed by. */
type Passing = Pick<Observed, 'next' | 'nextSinceUs'> & { readonly moments: readonly Moment[] };

/** Finds between which turns the robot passed by the place that was next at the end of its run; `null`: it did not. */
export function passedBy({ moments, next, nextSinceUs }: Passing, course: Scene): PassedBy | null {
  const [zone] = next;
  if (zone === undefined || zone.blocks > 0 || next.length !== 1) return null;
  const near = nearestTo(zone, moments, nextSinceUs);
  if (near === null || near.mm > BESIDE_MM) return null;
  const { moment, place } = near;
  const turns = turnsIn(moments);
  const made = turns.filter(({ to }) => to <= place).length;
  const last = moments[turns.find(({ to }) => to > place)?.from ?? moments.length - 1] ?? moment;
  const way = { x: last.pose.xMm - moment.pose.xMm, y: last.pose.yMm - moment.pose.yMm };
  const ahead = along(moment, way);
  const toZone = { x: zone.at[0] - moment.pose.xMm, y: zone.at[1] - moment.pose.yMm };
  const across = beside(moment, toZone);
  // Of a zone ahead nothing can be said before the robot has passed it.
  if (ahead < BEYOND_MM || Math.abs(across) < Math.abs(along(moment, toZone)) / 2) return null;
  const checkpoint =
    zone.type === 'checkpoint' && course.objects.filter(({ type }) => type === 'checkpoint').length > 1;
  return {
    atS: moment.timeUs / 1_000_000,
    side: across > 0 ? 'right' : 'left',
    turns: made > MOST_TURNS ? 0 : made,
    checkpoint: checkpoint ? zone.number : null,
  };
}

/** The part of a way along the heading, and across it to the left. */
const along = ({ pose }: Moment, { x, y }: Vec): number =>
  x * exactCos(pose.headingRad) + y * exactSin(pose.headingRad);
const beside = ({ pose }: Moment, { x, y }: Vec): number =>
  y * exactCos(pose.headingRad) - x * exactSin(pose.headingRad);

/** A moment of a run with its place among them, and how far the robot was from something. */
interface Near {
  readonly moment: Moment;
  readonly place: number;
  readonly mm: number;
}

function nearestTo(zone: Zone, moments: readonly Moment[], sinceUs: number): Near | null {
  const outline = shapeOutline(zone);
  let best: Near | null = null;
  for (const [place, moment] of moments.entries()) {
    if (moment.timeUs < sinceUs) continue;
    const at = { x: moment.pose.xMm, y: moment.pose.yMm };
    const mm = zoneHolds(zone, at) ? 0 : distanceToEdge(outline, at);
    if (best === null || mm < best.mm) best = { moment, place, mm };
  }
  return best;
}

/** Simulated time at the end of a run for which a state must have lasted to be told. Chosen. */
const LASTING_US = 2_000_000;
/** A robot that stays within this stands, or turns at one place. */
const [STILL_MM, PLACE_MM] = [2, 15];

/** Since when the robot has stood still at the end; `null`: it does not. */
export const standsSince = (moments: readonly Moment[]): number | null =>
  lasting(moments, (one, last) => distance(one, last) < STILL_MM && Math.abs(turned(one, last)) < 0.02);

/** Since when it has turned at one place at the end; `null`: it does not. */
export function turnsSince(moments: readonly Moment[]): number | null {
  const since = lasting(moments, (one, last) => distance(one, last) < PLACE_MM);
  const from = moments.find(({ timeUs }) => timeUs === since);
  const last = moments.at(-1);
  return from !== undefined && last !== undefined && Math.abs(turned(from, last)) > 2 * Math.PI ? since : null;
}

function lasting(moments: readonly Moment[], isSame: (one: Moment, last: Moment) => boolean): number | null {
  const last = moments.at(-1);
  if (last === undefined) return null;
  const before = moments.findLastIndex((one) => !isSame(one, last));
  const from = moments[before + 1];
  return from !== undefined && last.timeUs - from.timeUs >= LASTING_US ? from.timeUs : null;
}

const distance = ({ pose: a }: Moment, { pose: b }: Moment): number => {
  const [x, y] = [a.xMm - b.xMm, a.yMm - b.yMm];
  return Math.sqrt(x * x + y * y);
};
const turned = ({ pose: a }: Moment, { pose: b }: Moment): number => b.headingRad - a.headingRad;
