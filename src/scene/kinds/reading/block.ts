import type { Block, Spikes } from '../../scene';
import type { KindReader } from './kind-reader';
import { readBody } from './unread';

/** Reads a kind of which nothing is said but where it stands, its shape and how it is turned. */
const bodyReader = (type: (Block | Spikes)['type']): KindReader<Block | Spikes> => ({
  properties: ['at', 'size', 'angle', 'round', 'corners'],
  read: (given) => ({ type, ...readBody(given) }),
});

export const block = bodyReader('block');
export const fixedBlock = bodyReader('fixed-block');
export const spikes = bodyReader('spikes');
