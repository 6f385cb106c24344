import { braces, pair, property, shapeProperties } from '../json-text';
import { stopsOf } from './mover-way';
import { boundsOfOutline, convexHull, overlapMm, type Outline } from '../outline';
import { sceneDefaults, type Chase, type Mover } from '../scene';
import { shapeOutline } from '../shape/shape';
import type { SceneKind } from './kind';

/** Bodies that move by themselves. */
export const mover: SceneKind<Mover> = {
  name: 'moving block',
  write: (mover, rotation) => [
    ...shapeProperties(mover, rotation),
    ...property('round', mover.round ?? sceneDefaults.round, sceneDefaults.round),
    ...property('height', mover.height ?? null, null),
    ...(isAtPlace(mover) && (mover.chases || mover.spin !== undefined) ? [] : [`"to": ${pair(mover.to)}`]),
    ...(mover.stops ? [`"stops": [${mover.stops.map(pair).join(', ')}]`] : []),
    ...(mover.waits ? [`"waits": [${mover.waits.join(', ')}]`] : []),
    ...property('loops', mover.loops ?? false, false),
    ...property('phase', mover.phase ?? 0, 0),
    ...property('speed', mover.speed, sceneDefaults.speed),
    ...property('spin', mover.spin ?? 0, 0),
    ...(mover.chases ? [`"chases": ${chaseText(mover.chases)}`] : []),
    ...property('spiked', mover.spiked, sceneDefaults.spiked),
  ],
  solid: (mover) => [shapeOutline(mover)],
  bounds: (mover) => boundsOfOutline(legOutlines(mover).flat()),
  reachesInto: (mover, arena) => legOutlines(mover).some((leg) => overlapMm(leg, arena) > 0),
};

const chaseText = ({ zone, reach }: Chase): string => {
  const said = [...property('zone', zone ?? null, null), ...property('reach', reach ?? null, null)];
  return said.length === 0 ? '{}' : braces(said);
};

const isAtPlace = ({ at, to }: Mover): boolean => at[0] === to[0] && at[1] === to[1];

/**
 * The ground that a mover passes over, leg by leg: the outlines at both ends and what lies between. Of one without a way
 * the outline at its start.
 */
export function legOutlines(mover: Mover): readonly Outline[] {
  const outlines = stopsOf(mover).map(({ at }) => shapeOutline({ ...mover, at }));
  const [first = [], ...others] = outlines;
  if (others.length === 0) return [first];
  const legs = others.map((outline, index) => convexHull([...(outlines[index] ?? []), ...outline]));
  return mover.loops && others.length > 1 ? [...legs, convexHull([...(others.at(-1) ?? []), ...first])] : legs;
}
