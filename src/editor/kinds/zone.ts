import { paintColors, type PaintColor } from '#scene/paint/paint';
import { sceneLimits, type Point, type Scene, type Zone } from '#scene/scene';
import { countField, typeField, type Field } from '../object-fields';
import { boxed, boxFields } from './box';
import type { EditorKind } from './kind';
import { shapeNames, type ShapeName } from '#scene/shape/shape';
import { newCornersOf, shapeField } from './shapes';

/** Kinds of zones, which can become each other. */
const zoneKinds = ['target', 'checkpoint', 'forbidden'] as const;

/** A kind of zones; `size`: of those that are put by a tap. */
const zoneKind = (type: Zone['type'], size: Point): EditorKind<Zone> => ({
  layer: 0,
  ...boxed,
  fields: (zone) => [
    typeField(zone.type, zoneKinds, (type, scene) => {
      const number = numberOf(type, scene);
      const { blockColor: _, ...rest } = zone;
      return number === null ? null : { ...rest, type, number, blocks: 0 };
    }),
    ...(type === 'checkpoint'
      ? [countField('number', zone.number, sceneLimits.checkpoint, (number) => ({ ...zone, number }))]
      : []),
    ...(type === 'target' ? blocksFields(zone) : []),
    shapeField(zone, shapeNames, (bare, shape) => ({ ...bare, ...zoneShapeOf(shape) })),
    ...boxFields(zone),
  ],
  made(id, at, scene, { zoneShape, zoneBlocks, zoneBlockColor }) {
    const number = numberOf(type, scene);
    if (number === null) return null;
    return {
      type,
      id,
      at,
      size,
      angle: 0,
      ...zoneShapeOf(zoneShape),
      number,
      ...(type === 'target' ? wanting(zoneBlocks, zoneBlockColor) : wanting(0, null)),
    };
  },
});

/** The properties of a target that wants blocks, of one colour or (`null`) of any. */
const wanting = (blocks: number, color: PaintColor | null): Pick<Zone, 'blocks' | 'blockColor'> => ({
  blocks,
  ...(blocks > 0 && color !== null && { blockColor: color }),
});

/** The fields of the blocks that a target wants. */
function blocksFields({ blocks, blockColor: wanted, ...zone }: Zone): readonly Field<Zone>[] {
  const blockColor = wanted ?? null;
  const count = countField('blocks', blocks, sceneLimits.blocks, (some) => ({ ...zone, ...wanting(some, blockColor) }));
  if (blocks === 0) return [count];
  const color: Field<Zone> = {
    ...{ kind: 'choice', name: 'blockColor', value: blockColor ?? 'any', choices: ['any', ...paintColors] },
    with: (value: PaintColor | 'any') => ({ ...zone, ...wanting(blocks, value === 'any' ? null : value) }),
  };
  return [count, color];
}

// Sizes chosen: a robot fits in with room to spare.

/** A place that the robot, or blocks, must reach. */
export const target = zoneKind('target', [200, 200]);

/** A place to be passed in the order of its numbers. */
export const checkpoint = zoneKind('checkpoint', [150, 150]);

/** A place that must not be entered. */
export const forbidden = zoneKind('forbidden', [200, 200]);

/** The properties of a zone's shape, always with `round`. */
const zoneShapeOf = (shape: ShapeName): Pick<Zone, 'round' | 'corners'> => ({
  round: shape === 'round',
  ...newCornersOf(shape),
});

const numberOf = (type: Zone['type'], scene: Scene): number | null =>
  type === 'checkpoint' ? nextCheckpoint(scene) : 0;

/** The number of the next checkpoint: one more than the highest, or the lowest free one; `null` when all are used. */
export function nextCheckpoint(scene: Scene, alsoTaken: readonly number[] = []): number | null {
  const taken = new Set(alsoTaken);
  for (const object of scene.objects) if (object.type === 'checkpoint') taken.add(object.number);
  const highest = Math.max(0, ...taken);
  const { min, max } = sceneLimits.checkpoint;
  if (highest < max) return highest + 1;
  for (let number = min; number <= max; number += 1) if (!taken.has(number)) return number;
  return null;
}
