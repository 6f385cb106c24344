import type { Block, Spikes } from '../../scene';
import type { KindReader } from './kind-reader';
import { readBody, readHeight } from './unread';

/** Reads a kind whose only properties are its place, its shape, its rotation and its height. */
const bodyReader = (type: (Block | Spikes)['type']): KindReader<Block | Spikes> => ({
  properties: ['at', 'size', 'angle', 'round', 'corners', 'height'],
  read: (given) => ({ type, ...readBody(given), ...readHeight(given) }),
});

export const block = bodyReader('block');
export const fixedBlock = bodyReader('fixed-block');
export const spikes = bodyReader('spikes');
