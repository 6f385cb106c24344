import { isSame } from '#core/same';
import { wallOutline } from '#scene/kinds/wall';
import { heightProperty } from '#scene/kinds/heights';
import { sceneLimits, type Wall } from '#scene/scene';
import { endFields, heightField, lengthField } from '../object-fields';
import { distanceMm, middleBetween, minus, toVec } from '../plane';
import { otherWalls, snappedTo } from '../snap';
import { hitWithin, mirroredPoint, scaledPoint, shifted, type EditorKind } from './kind';
import { lineHandles, turnedEnds } from './line';
import type { ToolOptions } from '../tools/tool';

/** Length of a wall that is added without a pointer, in mm. Chosen: a cell of a maze and a bit. */
const NEW_MM = 200;

/** Walls; no edit leaves one without length. */
export const wall: EditorKind<Wall> = {
  layer: 3,
  place: ({ from }) => from,
  span: ({ from, to }) => minus(toVec(to), toVec(from)),
  middle: ({ from, to }) => middleBetween(toVec(from), toVec(to)),
  extentMm: ({ from, to }) => distanceMm(toVec(from), toVec(to)),
  ...hitWithin<Wall>(wallOutline),
  moved: (wall, dx, dy) => ({ ...wall, from: shifted(wall.from, dx, dy), to: shifted(wall.to, dx, dy) }),
  // At the very end of what a course may hold a turn could press the ends together.
  turned: (wall, pivot, angleDeg) => withEnds(wall, ...turnedEnds(wall.from, wall.to, pivot, angleDeg)) ?? wall,
  mirrored: (wall, axis, atMm) => ({
    ...wall,
    from: mirroredPoint(wall.from, axis, atMm),
    to: mirroredPoint(wall.to, axis, atMm),
  }),
  scaled: (wall, about, factor) =>
    withEnds(wall, scaledPoint(wall.from, about, factor), scaledPoint(wall.to, about, factor)),
  handles: ({ id, from, to, thickness }, reachMm) => lineHandles(id, [from, to], thickness, reachMm),
  endMoved(wall, end, place, { reachMm, free, lure }, scene) {
    const stays = end === 'from' ? wall.to : wall.from;
    const to = snappedTo(stays, place, otherWalls(scene, wall), { size: scene.size, reachMm, free, lure });
    return isSame(stays, to) ? null : { ...wall, [end]: to };
  },
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

/** Thickness and height of the walls that the tools draw. */
export const newWallLook = ({ wallThickness, wallHeight }: ToolOptions): Pick<Wall, 'thickness' | 'height'> => ({
  thickness: wallThickness,
  ...heightProperty('wall', wallHeight),
});

const withEnds = (wall: Wall, from: Wall['from'], to: Wall['to']): Wall | null =>
  isSame(from, to) ? null : { ...wall, from, to };
