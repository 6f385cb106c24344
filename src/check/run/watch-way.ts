import type { Pose, Vec } from '#core/geometry';
import { zoneHolds, isZone } from '#scene/kinds/zone';
import { usOf } from '#core/seconds';
import type { Scene, Zone } from '#scene/scene';
import { Laps } from './laps';
import { metAt, OPEN, type Standing, type Watcher } from './watcher';

/** A robot at rest stays within this. Chosen: below what a ruler shows, above what rounding makes. */
const STILL_MM = 0.05;
const STILL_RAD = 0.0005;

const placeOf = ({ xMm, yMm }: Pose): Vec => ({ x: xMm, y: yMm });

const ofType = ({ objects }: Scene, type: Zone['type']): readonly Zone[] =>
  objects.filter((object): object is Zone => isZone(object) && object.type === type);

/** Watches whether the robot stands still for that long, in a zone if the check or the course has one. */
export function watchStop(
  course: Scene,
  { seconds, zone }: { readonly seconds: number; readonly zone: string | null },
): Watcher {
  const named = course.objects.filter(isZone).filter(({ id }) => id === zone);
  const zones = zone === null ? ofType(course, 'target').filter(({ blocks }) => blocks === 0) : named;
  const isAnywhere = zone === null && zones.length === 0;
  let standing: Standing = OPEN;
  let since: { readonly timeUs: number; readonly x: number; readonly y: number; readonly headingRad: number } | null =
    null;
  let hasMoved = false;
  return {
    step: ({ nowUs: timeUs, pose }) => {
      if (standing !== OPEN || pose === null) return;
      const { headingRad } = pose;
      const { x, y } = placeOf(pose);
      const isStill =
        since !== null &&
        Math.abs(x - since.x) < STILL_MM &&
        Math.abs(y - since.y) < STILL_MM &&
        Math.abs(headingRad - since.headingRad) < STILL_RAD;
      if (isStill && since !== null) {
        const isThere = isAnywhere ? hasMoved : zones.some((one) => zoneHolds(one, { x, y }));
        if (isThere && timeUs - since.timeUs >= usOf(seconds)) standing = metAt(timeUs);
        return;
      }
      hasMoved ||= since !== null;
      since = { timeUs, x, y, headingRad };
    },
    standing: () => standing,
    reason: () => ({ code: 'stop', params: { seconds } }),
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
    reason: () => ({ code: 'checkpoints', params: { done: of - left.size, of } }),
  };
}

/** Watches rounds: `Laps` says what one is. */
export function watchLaps(course: Scene, count: number): Watcher {
  const targets = ofType(course, 'target').filter(({ blocks }) => blocks === 0);
  const laps = new Laps(ofType(course, 'checkpoint'), targets);
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
