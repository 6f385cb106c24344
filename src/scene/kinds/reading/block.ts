import type { Block, Spikes } from '../../scene';
import type { KindReader } from './kind-reader';
import { readBody, readHeight, readPaint } from './unread';

const properties = ['at', 'size', 'angle', 'round', 'corners', 'height'];

const blockReader = (type: Block['type']): KindReader<Block> => ({
  properties: [...properties, 'color', 'infrared'],
  read: (given) => ({ type, ...readBody(given), ...readHeight(given), ...readPaint(given) }),
});

export const block = blockReader('block');
export const fixedBlock = blockReader('fixed-block');
export const spikes: KindReader<Spikes> = {
  properties,
  read: (given) => ({ type: 'spikes', ...readBody(given), ...readHeight(given) }),
};
