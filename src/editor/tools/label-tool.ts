import { endOf } from '../drag';
import { adding } from '../edits';
import { newObject } from '../kinds/index';
import { oneLine } from '../kinds/label';
import { toPoint } from '../plane';
import { isInArena, onGrid } from '../snap';
import type { Tool } from './tool';

/** Puts the words of the options where the drag ends; without words it does nothing. */
export const labelTool: Tool = {
  id: 'label',
  cursor: 'text',
  edit(drag, { scene, options }) {
    const place = endOf(drag);
    if (oneLine(options.labelText) === '' || !isInArena(place, scene.size)) return null;
    const at = toPoint(drag.free ? place : onGrid(place, drag.reachMm));
    const label = newObject(scene, 'label', at, options);
    return label && adding(scene, [label]);
  },
};
