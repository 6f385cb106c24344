import { boxProperties } from '../json-text';
import { boxOutline } from '../outline';
import type { Block, Spikes } from '../scene';
import { standing, type SceneKind } from './kind';
import { readBox } from './unread';

/** A kind of which nothing is said but where it stands, how large and how turned. */
const boxKind = (type: (Block | Spikes)['type'], name: string = type): SceneKind<Block | Spikes> => ({
  name,
  properties: ['at', 'size', 'turn'],
  read: (given) => ({ type, ...readBox(given) }),
  write: boxProperties,
  ...standing<Block | Spikes>(boxOutline),
});

/** Movable blocks. */
export const block = boxKind('block');

/** Blocks that stand fast. */
export const fixedBlock = boxKind('fixed-block', 'block');

/** Spikes. */
export const spikes = boxKind('spikes');
