import type { Block, Spikes } from '../../scene';
import type { KindReader } from './kind-reader';
import { readBody } from './unread';

/** Reads a kind whose only properties are its place, its shape and its rotation. */
const bodyReader = (type: (Block | Spikes)['type']): KindReader<Block | Spikes> => ({
  properties: ['at', 'size', 'angle', 'round', 'corners'],
  read: (given) => ({ type, ...readBody(given) }),
});

export const block = bodyReader('block');
export const fixedBlock = bodyReader('fixed-block');
export const spikes = bodyReader('spikes');
