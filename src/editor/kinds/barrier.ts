import { wallOutline } from '#scene/kinds/wall';
import { sceneDefaults, sceneLimits, type Barrier } from '#scene/scene';
import { switchWays } from '#scene/kinds/switching';
import { endFields, heightField, lengthField } from '../object-fields';
import { hitWithin, type EditorKind } from './kind';
import { straight, withEnds } from './straight';
import { switchFields } from './switch-fields';

/** Length of a barrier that is added, in mm. Chosen: across a road for robots. */
const NEW_MM = 200;

/** Barriers; no edit leaves one without length. */
export const barrier: EditorKind<Barrier> = {
  layer: 3,
  ...straight,
  ...hitWithin<Barrier>(wallOutline),
  fields: (barrier) => [
    ...switchFields(barrier.opens, switchWays, (opens) => ({ ...barrier, opens: opens ?? 'hand' }), {
      radio: { radio: ['open', 'close'] },
    }),
    ...endFields(barrier.from, barrier.to, (from, to) => withEnds(barrier, from, to)),
    lengthField('thickness', barrier.thickness, sceneLimits.thicknessMm, 1, (thickness) => ({ ...barrier, thickness })),
    heightField(barrier),
  ],
  made: (id, [x, y]) => ({
    ...{ type: 'barrier', id, from: [x - NEW_MM / 2, y], to: [x + NEW_MM / 2, y] },
    ...{ thickness: sceneDefaults.thickness, opens: 'hand' },
  }),
};
