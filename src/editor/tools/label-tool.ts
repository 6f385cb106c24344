import { endOf } from '../drag';
import { adding } from '../edits';
import { newObject } from '../kinds/index';
import { oneLine } from '../kinds/label';
import { toPoint } from '../plane';
import { isInArena } from '../snap';
import { snappedObject } from '../snap/attract';
import type { Tool } from './tool';

/** Puts the words of the options where the drag ends; without words it does nothing. */
export const labelTool: Tool = {
  id: 'label',
  putsDown: true,
  cursor: 'text',
  edit(drag, context) {
    const { scene, options } = context;
    const place = endOf(drag);
    if (oneLine(options.labelText) === '' || !isInArena(place, scene.size)) return null;
    const label = newObject(scene, 'label', toPoint(place), options);
    return label && adding(scene, [snappedObject(label, drag, context)]);
  },
};
