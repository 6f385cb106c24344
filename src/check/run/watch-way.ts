import type { Pose, Vec } from '#core/geometry';
import { isZone, zoneContains, zoneHolds } from '#scene/kinds/zone';
import { usOf } from '#core/seconds';
import type { Scene, Zone } from '#scene/scene';
import { rotationRad } from '#core/angle';
import type { Stop } from '../task/task';
import { Laps } from './laps';
import { metAt, OPEN, type Standing, type Step, type Watcher } from './watcher';

/** A robot at rest stays within this. Chosen: below what a ruler shows, above what rounding makes. */
const STILL_MM = 0.05;
const STILL_RAD = 0.0005;

const placeOf = ({ xMm, yMm }: Pose): Vec => ({ x: xMm, y: yMm });

const ofType = ({ objects }: Scene, type: Zone['type']): readonly Zone[] =>
  objects.filter((object): object is Zone => isZone(object) && object.type === type);

/** The zone of this id, or all targets of the robot. */
function zonesFor(course: Scene, zone: string | null): readonly Zone[] {
  return zone === null ? targetsOf(course) : course.objects.filter(isZone).filter(({ id }) => id === zone);
}

const targetsOf = (course: Scene): readonly Zone[] => ofType(course, 'target').filter(({ blocks }) => blocks === 0);

const isInOneOf = (zones: readonly Zone[], at: Vec): boolean => zones.some((one) => zoneHolds(one, at));

/** A robot that stands, and since when. */
interface Stand extends Vec {
  readonly timeUs: number;
  readonly headingRad: number;
}

const isStillAt = (since: Stand, { xMm, yMm, headingRad }: Pose): boolean =>
  Math.abs(xMm - since.x) < STILL_MM &&
  Math.abs(yMm - since.y) < STILL_MM &&
  Math.abs(headingRad - since.headingRad) < STILL_RAD;

/** Watches whether the robot stands still for that long, in a zone if the check or the course has one. */
export function watchStop(course: Scene, { seconds, zone, whole, heading, within }: Omit<Stop, 'type'>): Watcher {
  const zones = zonesFor(course, zone);
  const isAnywhere = zone === null && zones.length === 0;
  let standing: Standing = OPEN;
  let since: Stand | null = null;
  let hasMoved = false;
  /** The fault when it last stood there for long enough; `null`: none. */
  let lacks: 'whole' | 'heading' | null = null;
  const isThere = (stand: Stand): boolean => (isAnywhere ? hasMoved : isInOneOf(zones, stand));
  function faultOf({ headingRad }: Stand, body: Step['body']): typeof lacks {
    const isWhole = !whole || isAnywhere || zones.some((one) => body.every((part) => zoneContains(one, part)));
    if (!isWhole) return 'whole';
    return heading === null || degreesBetween(headingRad, heading) <= within ? null : 'heading';
  }
  return {
    step: (run) => {
      const { nowUs: timeUs, pose } = run;
      if (standing !== OPEN || pose === null) return;
      if (since !== null && isStillAt(since, pose)) {
        if (timeUs - since.timeUs < usOf(seconds) || !isThere(since)) return;
        lacks = faultOf(since, run.body);
        if (lacks === null) standing = metAt(timeUs);
        return;
      }
      hasMoved ||= since !== null;
      since = { timeUs, ...placeOf(pose), headingRad: pose.headingRad };
    },
    standing: () => standing,
    reason: () => ({
      code: lacks ?? 'stop',
      params: { seconds, ...(lacks === 'heading' && { heading: heading ?? 0 }) },
    }),
  };
}

/** Degrees between two directions, 0 to 180. */
function degreesBetween(headingRad: number, headingDeg: number): number {
  const turns = (headingRad - rotationRad(headingDeg)) / (2 * Math.PI);
  return Math.abs(turns - Math.round(turns)) * 360;
}

/** Watches whether the robot reaches one of the zones of these ids; none given: a target. */
export function watchReach(course: Scene, ids: readonly string[]): Watcher {
  const zones = ids.length === 0 ? targetsOf(course) : ids.flatMap((id) => zonesFor(course, id));
  let standing: Standing = OPEN;
  return {
    step: ({ nowUs, pose }) => {
      if (standing === OPEN && pose !== null && isInOneOf(zones, placeOf(pose))) standing = metAt(nowUs);
    },
    standing: () => standing,
    reason: () => ({ code: 'reach', params: {} }),
  };
}

/** Watches whether the robot is in a zone for that long, all visits together. */
export function watchStay(course: Scene, { seconds, zone }: Pick<Stop, 'seconds' | 'zone'>): Watcher {
  const zones = zonesFor(course, zone);
  let standing: Standing = OPEN;
  let spentUs = 0;
  let insideUs: number | null = null;
  return {
    step: ({ nowUs, pose }) => {
      if (standing !== OPEN || pose === null) return;
      const isInside = isInOneOf(zones, placeOf(pose));
      if (isInside && insideUs !== null) spentUs += nowUs - insideUs;
      insideUs = isInside ? nowUs : null;
      if (spentUs >= usOf(seconds)) standing = metAt(nowUs);
    },
    standing: () => standing,
    reason: () => ({ code: 'stay', params: { seconds, found: Math.floor(spentUs / 100_000) / 10 } }),
  };
}

/** Watches whether the robot reaches all checkpoints, in any order. */
export function watchCheckpoints(course: Scene): Watcher {
  const left = new Set(ofType(course, 'checkpoint'));
  const of = left.size;
  let standing: Standing = OPEN;
  return {
    step: ({ nowUs, pose }) => {
      if (standing !== OPEN || pose === null) return;
      for (const zone of left) if (zoneHolds(zone, placeOf(pose))) left.delete(zone);
      if (left.size === 0 && of > 0) standing = metAt(nowUs);
    },
    standing: () => standing,
    count: () => of - left.size,
    reason: () => ({ code: 'checkpoints', params: { done: of - left.size, of } }),
  };
}

/** Watches rounds: `Laps` says what one is. */
export function watchLaps(course: Scene, count: number): Watcher {
  const laps = new Laps(ofType(course, 'checkpoint'), targetsOf(course));
  let standing: Standing = OPEN;
  return {
    step: ({ nowUs, pose }) => {
      if (standing !== OPEN || pose === null) return;
      laps.visit(placeOf(pose));
      if (laps.count >= count) standing = metAt(nowUs);
    },
    standing: () => standing,
    reason: () => ({ code: 'laps', params: { done: laps.count, of: count } }),
  };
}
