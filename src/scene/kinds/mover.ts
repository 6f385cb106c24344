import { boxProperties, pair, property } from '../json-text';
import { boxOutline, convexHull, type Outline } from '../outline';
import { sceneDefaults, sceneLimits, type Mover } from '../scene';
import { filling, type SceneKind } from './kind';
import { readBox, readPlace } from './unread';

/** Boxes that go to and fro. */
export const mover: SceneKind<Mover> = {
  name: 'moving block',
  properties: ['at', 'to', 'size', 'turn', 'speed', 'spiked'],
  read: (given) => ({
    type: 'mover',
    ...readBox(given),
    to: readPlace(given, 'to'),
    speed: given.reader.whole(...given.at('speed'), sceneLimits.speedMmS, sceneDefaults.speed),
    spiked: given.reader.flag(...given.at('spiked'), sceneDefaults.spiked),
  }),
  write: (mover) => [
    ...boxProperties(mover),
    `"to": ${pair(mover.to)}`,
    ...property('speed', mover.speed, sceneDefaults.speed),
    ...property('spiked', mover.spiked, sceneDefaults.spiked),
  ],
  solid: boxOutline,
  ...filling(trackOutline),
};

/** The ground that a mover passes over: the outlines at its start and at its turning point, and what lies between. */
export function trackOutline(mover: Mover): Outline {
  const start = boxOutline(mover);
  const end = boxOutline({ ...mover, at: mover.to });
  return convexHull([...start, ...end]);
}
