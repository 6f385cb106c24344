import { paintProperties, property, shapeProperties } from '../json-text';
import { sceneDefaults, type Block, type Spikes } from '../scene';
import { shapeParts } from '../shape/shape';
import { standing, type SceneKind } from './kind';

/** A kind whose only properties are its place, its shape, its rotation, its height and its paint. */
const bodyKind = (name: string): SceneKind<Block | Spikes> => ({
  name,
  write: (body, rotation) => [
    ...shapeProperties(body, rotation),
    ...property('round', body.round ?? sceneDefaults.round, sceneDefaults.round),
    ...property('height', body.height ?? null, null),
    ...(body.type === 'spikes' ? [] : paintProperties(body)),
  ],
  ...standing<Block | Spikes>(shapeParts),
});

/** Movable blocks. */
export const block = bodyKind('block');

/** Blocks that stand fast. */
export const fixedBlock = bodyKind('block');

/** Spikes. */
export const spikes = bodyKind('spikes');
