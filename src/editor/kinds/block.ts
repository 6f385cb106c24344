import { heightProperty } from '#scene/kinds/heights';
import { colorProperty } from '#scene/paint/paint';
import type { Block, Spikes } from '#scene/scene';
import { heightField, typeField } from '../object-fields';
import { boxed, boxFields } from './box';
import type { EditorKind } from './kind';
import { shapeNames } from '#scene/shape/shape';
import { motionFields } from './motion-fields';
import { bodyShape, shapeField } from './shapes';

/** Kinds of blocks that can become each other. */
const boxKinds = ['block', 'fixed-block', 'spikes'] as const;

const boxKind = (type: (Block | Spikes)['type']): EditorKind<Block | Spikes> => ({
  layer: 3,
  ...boxed,
  fields: (box) => [
    typeField(box.type, boxKinds, (type) => ofType(box, type)),
    shapeField(box, shapeNames, (bare, shape) => ({
      ...(shape === 'round' ? bare : notRolling(bare)),
      ...bodyShape(shape),
    })),
    ...boxFields(box),
    heightField(box),
    ...(box.type === 'block' ? motionFields(box) : []),
  ],
  made: (id, at, _scene, { blockSize, blockShape, blockHeight, blockColor }) => ({
    ...{ type, id, at, size: blockSize, angle: 0 },
    ...bodyShape(blockShape),
    ...heightProperty(type, blockHeight),
    ...(type !== 'spikes' && colorProperty(blockColor)),
  }),
});

/** A thing in another's place: spikes have no colour, and only what can be pushed has a weight. */
function ofType(box: Block | Spikes, type: (typeof boxKinds)[number]): Block | Spikes {
  if (type === 'block') return { ...box, type };
  const { mass: _mass, friction: _friction, rolls: _rolls, ...still } = { ...NO_MOTION, ...box };
  if (type === 'fixed-block') return { ...still, type };
  const { color: _color, infrared: _infrared, ...bare } = { ...NO_PAINT, ...still };
  return { ...bare, type };
}
const NO_MOTION = { mass: undefined, friction: undefined, rolls: undefined };
const NO_PAINT = { color: undefined, infrared: undefined };

/** A thing without its rolling: only what is round rolls. */
function notRolling<O extends object>(box: O): O {
  const { rolls: _rolls, ...rest } = { rolls: undefined, ...box };
  return rest as O; // only that is gone
}

/** Movable blocks. */
export const block = boxKind('block');

/** Blocks that stand fast. */
export const fixedBlock = boxKind('fixed-block');

/** Spikes. */
export const spikes = boxKind('spikes');
