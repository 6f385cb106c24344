import { paintColors } from '#scene/paint/paint';
import type { Paper } from '#scene/scene';
import { shapeNames } from '#scene/shape/shape';
import { boxed, boxFields } from './box';
import type { EditorKind } from './kind';
import { bodyShape, shapeField } from './shapes';

/** Coloured sheets. */
export const paper: EditorKind<Paper> = {
  layer: 0,
  ...boxed,
  fields: (paper) => [
    {
      ...{ kind: 'choice', name: 'color', value: paper.color, choices: paintColors },
      with: (color: Paper['color']) => ({ ...paper, color }),
    },
    shapeField(paper, shapeNames, (bare, shape) => ({ ...bare, ...bodyShape(shape) })),
    ...boxFields(paper),
  ],
  // Chosen: a robot's colour sensor finds it, and a block lies in it with room to spare.
  made: (id, at, _scene, { zoneShape, penColor }) => ({
    ...{ type: 'paper', id, at, size: [110, 110], angle: 0, color: penColor },
    ...bodyShape(zoneShape),
  }),
};
