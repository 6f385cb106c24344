import { sceneLimits } from '#scene/scene';
import { endOf } from '../drag';
import { adding } from '../edits';
import { freeIds } from '../ids';
import { toPoint } from '../plane';
import { isInArena, onGrid } from '../snap';
import type { Tool } from './tool';

/** Puts the words of the options where the drag ends; without words it does nothing. */
export const labelTool: Tool = {
  id: 'label',
  cursor: 'text',
  edit(drag, { scene, options }) {
    const text = oneLine(options.labelText);
    const place = endOf(drag);
    if (text === '' || !isInArena(place, scene.size)) return null;
    const at = toPoint(drag.free ? place : onGrid(place, drag.reachMm));
    return adding(scene, [
      { type: 'label', id: freeIds(scene)('label'), at, text, height: options.labelHeight, turn: 0 },
    ]);
  },
};

/** Words as a label holds them: one line, no spaces around, not too long. */
export const oneLine = (text: string): string =>
  text.replace(/\s+/gu, ' ').trim().slice(0, sceneLimits.labelCharacters).replace(HALF_A_SIGN, '').trim();

/** What is left of a sign of two UTF-16 units that was cut in the middle. */
const HALF_A_SIGN = /[\uD800-\uDBFF]$/u;
