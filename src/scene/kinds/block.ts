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
    ...(body.type === 'spikes' ? [] : [...paintProperties(body), ...motionProperties(body)]),
  ],
  ...standing<Block | Spikes>(shapeParts),
});

/** How a block moves when it is pushed, in the form of a file. */
const motionProperties = ({ mass, friction, rolls }: Block): readonly string[] => [
  ...property('mass', mass ?? null, null),
  ...property('friction', friction ?? null, null),
  ...property('rolls', rolls ?? false, false),
];

/** Movable blocks. */
export const block = bodyKind('block');

/** Blocks that stand fast. */
export const fixedBlock = bodyKind('block');

/** Spikes. */
export const spikes = bodyKind('spikes');
