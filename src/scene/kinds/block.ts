import { property, shapeProperties } from '../json-text';
import { sceneDefaults, type Block, type Spikes } from '../scene';
import { shapeParts } from '../shape/shape';
import { standing, type SceneKind } from './kind';
import { readBody } from './unread';

/** A kind of which nothing is said but where it stands, its shape and how it is turned. */
const bodyKind = (type: (Block | Spikes)['type'], name: string = type): SceneKind<Block | Spikes> => ({
  name,
  properties: ['at', 'size', 'angle', 'round', 'corners'],
  read: (given) => ({ type, ...readBody(given) }),
  write: (body, rotation) => [
    ...shapeProperties(body, rotation),
    ...property('round', body.round ?? sceneDefaults.round, sceneDefaults.round),
  ],
  ...standing<Block | Spikes>(shapeParts),
});

/** Movable blocks. */
export const block = bodyKind('block');

/** Blocks that stand fast. */
export const fixedBlock = bodyKind('fixed-block', 'block');

/** Spikes. */
export const spikes = bodyKind('spikes');
