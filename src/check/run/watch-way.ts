import type { Vec } from '#core/geometry';
import { zoneHolds, isZone } from '#scene/kinds/zone';
import type { Scene, Zone } from '#scene/scene';
import type { Snapshot } from '#simulation/snapshot';
import { metAt, OPEN, type Standing, type Watcher } from './watcher';

/** Within a step of the world a robot at rest does not move farther than its figures are rounded. */
const STILL_MM = 0.05;
const STILL_RAD = 0.0005;

const placeIn = ({ robot }: Snapshot): Vec | null => (robot === null ? null : { x: robot.pose.xMm, y: robot.pose.yMm });

const ofType = ({ objects }: Scene, type: Zone['type']): readonly Zone[] =>
  objects.filter((object): object is Zone => isZone(object) && object.type === type);

/** Watches whether the robot stands still for so long, in a zone if the check or the course has one. */
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
    moment: ({ timeUs, robot }) => {
      if (standing !== OPEN || robot === null) return;
      const { xMm: x, yMm: y, headingRad } = robot.pose;
      const isStill =
        since !== null &&
        Math.abs(x - since.x) < STILL_MM &&
        Math.abs(y - since.y) < STILL_MM &&
        Math.abs(headingRad - since.headingRad) < STILL_RAD;
      if (isStill && since !== null) {
        const isThere = isAnywhere ? hasMoved : zones.some((one) => zoneHolds(one, { x, y }));
        if (isThere && timeUs - since.timeUs >= seconds * 1_000_000) standing = metAt(timeUs);
        return;
      }
      hasMoved ||= since !== null;
      since = { timeUs, x, y, headingRad };
    },
    standing: () => standing,
    reason: () => ({ code: 'stop', params: { seconds } }),
  };
}

/** Watches whether the robot comes to all checkpoints, whatever their order. */
export function watchCheckpoints(course: Scene): Watcher {
  const left = new Set(ofType(course, 'checkpoint'));
  const of = left.size;
  let standing: Standing = OPEN;
  return {
    moment: (snapshot) => {
      const place = placeIn(snapshot);
      if (standing !== OPEN || place === null) return;
      for (const zone of left) if (zoneHolds(zone, place)) left.delete(zone);
      if (left.size === 0 && of > 0) standing = metAt(snapshot.timeUs);
    },
    standing: () => standing,
    reason: () => ({ code: 'checkpoints', params: { done: of - left.size, of } }),
  };
}

/**
 * Watches rounds: all checkpoints in their order, then the targets, or without a target the first checkpoint again. The
 * round begins anew with that.
 */
export function watchLaps(course: Scene, count: number): Watcher {
  const checkpoints = ofType(course, 'checkpoint').toSorted((a, b) => a.number - b.number);
  const targets = ofType(course, 'target').filter(({ blocks }) => blocks === 0);
  const round = targets.length > 0 ? [...checkpoints, ...targets] : checkpoints;
  const isRing = targets.length === 0;
  let [next, laps, isStarted] = [0, 0, false];
  let standing: Standing = OPEN;
  const arrive = (timeUs: number): void => {
    const isFirst = isRing && next === 0;
    if (isFirst && isStarted) laps += 1;
    isStarted = true;
    next += 1;
    if (next === round.length) {
      if (!isRing) laps += 1;
      next = 0;
    }
    if (laps >= count) standing = metAt(timeUs);
  };
  return {
    moment: (snapshot) => {
      const place = placeIn(snapshot);
      const zone = round[next];
      if (standing === OPEN && place !== null && zone !== undefined && zoneHolds(zone, place)) arrive(snapshot.timeUs);
    },
    standing: () => standing,
    reason: () => ({ code: 'laps', params: { done: laps, of: count } }),
  };
}
