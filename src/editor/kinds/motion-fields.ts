import { sceneDefaults, sceneLimits, type Block } from '#scene/scene';
import { shapeParts } from '#scene/shape/shape';
import { areaOf } from '#scene/shape/polygon';
import type { Field } from '../object-fields';

/** The mass that a block has by itself, in g: as `#world` has it, a wooden block of 5 × 5 cm weighs 40 g. */
const usualMass = (block: Block): number => {
  const areaMm2 = shapeParts(block).reduce((sum, part) => sum + areaOf(part.map(({ x, y }) => [x, y])), 0);
  return Math.max(sceneLimits.massG.min, Math.round((areaMm2 * 40) / 2500));
};

/** The fields of how a block moves when it is pushed. */
export const motionFields = (block: Block): readonly Field<Block>[] => [
  ...(block.round === true ? [rollsField(block)] : []),
  {
    ...{
      kind: 'number',
      name: 'mass',
      value: block.mass ?? usualMass(block),
      ...sceneLimits.massG,
      step: 5,
      unit: 'g',
    },
    with: (mass: number) => {
      const { mass: _mass, ...rest } = block;
      return mass === usualMass(block) ? rest : { ...rest, mass };
    },
  },
  {
    ...{ kind: 'number', name: 'friction', value: block.friction ?? usualFriction(block) },
    ...{ ...sceneLimits.friction, step: 0.05, unit: 'ratio' },
    with: (friction: number) => {
      const { friction: _friction, ...rest } = block;
      return friction === usualFriction(block) ? rest : { ...rest, friction };
    },
  },
];

const rollsField = (block: Block): Field<Block> => ({
  ...{ kind: 'switch', name: 'rolls', value: block.rolls === true },
  with: (rolls: boolean) => withRolling(block, rolls),
});

const usualFriction = ({ rolls }: Block): number =>
  rolls === true ? sceneDefaults.rollingFriction : sceneDefaults.friction;

function withRolling({ rolls: _rolls, ...rest }: Block, rolls: boolean): Block {
  return rolls ? { ...rest, rolls: true } : rest;
}
