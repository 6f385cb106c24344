import { isZone } from '#scene/kinds/zone';
import { stopsOf, wayOf, type MoverWay } from '#scene/kinds/mover-way';
import type { Mover, Scene } from '#scene/scene';
import { freeIds } from '../ids';
import { distanceMm, toVec } from '../plane';
import { turnedOff, usualStop } from './mover-stops';

/** Spin of a mover that only turns, until another one is set, in degrees per second. Chosen: a full turn in 4 s. */
const USUAL_SPIN = 90;

/** A mover that moves in another way; the properties of its old way are left out. */
export function withWay(mover: Mover, way: MoverWay, scene: Scene): Mover {
  const { stops, waits, loops: _loops, phase, chases, ...rest } = mover;
  const stays = { ...rest, to: rest.at };
  switch (way) {
    case 'stays':
      return { ...stays, spin: rest.spin ?? USUAL_SPIN };
    case 'chases':
      return { ...stays, chases: chases?.reach === undefined ? {} : { reach: chases.reach } };
    case 'guards':
      return { ...stays, chases: { ...chases, zone: zoneFor(mover, scene) } };
    case 'to-and-fro':
    case 'round': {
      const travels = {
        ...{ ...rest, to: stopsOf(mover)[1]?.at ?? usualStop(rest.at, scene.size) },
        ...(stops ? { stops } : {}),
        ...(waits ? { waits } : {}),
        ...(phase === undefined ? {} : { phase }),
      };
      return way === 'round' ? goingRound(travels, scene) : travels;
    }
    default:
      return way satisfies never;
  }
}

/** Between two stops there is nothing to go round: it gets a third. */
function goingRound(mover: Mover, { size }: Scene): Mover {
  return { ...mover, loops: true, stops: mover.stops ?? [turnedOff(mover.at, mover.to, size)] };
}

/** The id of the nearest zone; in a course without zones that of the next target to be put. */
function zoneFor({ at }: Mover, scene: Scene): string {
  const farness = (place: Mover['at']): number => distanceMm(toVec(place), toVec(at));
  const [nearest] = scene.objects.filter(isZone).sort((one, other) => farness(one.at) - farness(other.at));
  return nearest?.id ?? freeIds(scene)('target');
}

/** True if it goes from stop to stop. */
export const travels = (mover: Mover): boolean => ['to-and-fro', 'round'].includes(wayOf(mover));
