import { wallOutline } from '#scene/kinds/wall';
import { heightProperty } from '#scene/kinds/heights';
import { colorProperty } from '#scene/paint/paint';
import { sceneLimits, type Wall } from '#scene/scene';
import { endFields, heightField, lengthField } from '../object-fields';
import { hitWithin, type EditorKind } from './kind';
import { straight, withEnds } from './straight';
import type { ToolOptions } from '../tools/tool';

/** Length of a wall that is added without a pointer, in mm. Chosen: a cell of a maze and a bit. */
const NEW_MM = 200;

/** Walls; no edit leaves one without length. */
export const wall: EditorKind<Wall> = {
  layer: 3,
  ...straight,
  ...hitWithin<Wall>(wallOutline),
  fields: (wall) => [
    ...endFields(wall.from, wall.to, (from, to) => withEnds(wall, from, to)),
    lengthField('thickness', wall.thickness, sceneLimits.thicknessMm, 1, (thickness) => ({ ...wall, thickness })),
    heightField(wall),
  ],
  made: (id, [x, y], _scene, options) => ({
    ...{ type: 'wall', id, from: [x - NEW_MM / 2, y], to: [x + NEW_MM / 2, y] },
    ...newWallLook(options),
  }),
};

/** Thickness, height and colour of the walls that the tools draw. */
export const newWallLook = ({
  wallThickness,
  wallHeight,
  wallColor,
}: ToolOptions): Pick<Wall, 'thickness' | 'height' | 'color'> => ({
  thickness: wallThickness,
  ...heightProperty('wall', wallHeight),
  ...colorProperty(wallColor),
});
