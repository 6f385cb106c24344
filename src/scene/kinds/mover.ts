import { pair, property, shapeProperties } from '../json-text';
import { convexHull, type Outline } from '../outline';
import { sceneDefaults, sceneLimits, type Mover } from '../scene';
import { shapeOutline } from '../shape/shape';
import { filling, type SceneKind } from './kind';
import { readBody, readPlace } from './unread';

/** Bodies that go to and fro. */
export const mover: SceneKind<Mover> = {
  name: 'moving block',
  properties: ['at', 'to', 'size', 'angle', 'round', 'speed', 'spiked'],
  read: (given) => ({
    type: 'mover',
    ...readBody(given),
    to: readPlace(given, 'to'),
    speed: given.reader.whole(...given.at('speed'), sceneLimits.speedMmS, sceneDefaults.speed),
    spiked: given.reader.flag(...given.at('spiked'), sceneDefaults.spiked),
  }),
  write: (mover, rotation) => [
    ...shapeProperties(mover, rotation),
    ...property('round', mover.round ?? sceneDefaults.round, sceneDefaults.round),
    `"to": ${pair(mover.to)}`,
    ...property('speed', mover.speed, sceneDefaults.speed),
    ...property('spiked', mover.spiked, sceneDefaults.spiked),
  ],
  solid: (mover) => [shapeOutline(mover)],
  ...filling(trackOutline),
};

/** The ground that a mover passes over: the outlines at its start and at its turning point, and what lies between. */
export function trackOutline(mover: Mover): Outline {
  const start = shapeOutline(mover);
  const end = shapeOutline({ ...mover, at: mover.to });
  return convexHull([...start, ...end]);
}
