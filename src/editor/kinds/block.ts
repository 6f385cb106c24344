import { heightProperty } from '#scene/kinds/heights';
import type { Block, Spikes } from '#scene/scene';
import { heightField, typeField } from '../object-fields';
import { boxed, boxFields } from './box';
import type { EditorKind } from './kind';
import { shapeNames } from '#scene/shape/shape';
import { bodyShape, shapeField } from './shapes';

/** Kinds of blocks that can become each other. */
const boxKinds = ['block', 'fixed-block', 'spikes'] as const;

const boxKind = (type: (Block | Spikes)['type']): EditorKind<Block | Spikes> => ({
  layer: 3,
  ...boxed,
  fields: (box) => [
    typeField(box.type, boxKinds, (type) => (type === 'spikes' ? bare(box) : { ...box, type })),
    shapeField(box, shapeNames, (bare, shape) => ({ ...bare, ...bodyShape(shape) })),
    ...boxFields(box),
    heightField(box),
  ],
  made: (id, at, _scene, { blockSize, blockShape, blockHeight }) => ({
    ...{ type, id, at, size: blockSize, angle: 0 },
    ...bodyShape(blockShape),
    ...heightProperty(type, blockHeight),
  }),
});

/** Spikes in the place of a thing: they have no colour. */
function bare(box: Block | Spikes): Spikes {
  const { color: _color, infrared: _infrared, ...rest } = { color: undefined, infrared: undefined, ...box };
  return { ...rest, type: 'spikes' };
}

/** Movable blocks. */
export const block = boxKind('block');

/** Blocks that stand fast. */
export const fixedBlock = boxKind('fixed-block');

/** Spikes. */
export const spikes = boxKind('spikes');
