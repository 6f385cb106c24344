/** The drawing of coloured sheets with their words. Loaded when a course first has one. */
import { paper } from '#picture/kinds/paper';
import type { Look } from '#picture/look';
import { paints } from '#picture/paints';
import { group, written, type Shape } from '#picture/shapes';
import type { Paper } from '#scene/scene';
import { valueText } from '../../../course/editor/words/value-text';

/** Letters of the word on a sheet: their height in mm, and as a share of the sheet's. Chosen, to be read beside robots. */
const LETTERS_MM = 14;
const LETTERS_SHARE = 0.2;

/** A sheet and, for those who cannot tell colours apart, its colour as a word. */
export const sheet = (object: Paper, look: Look): readonly Shape[] => [
  ...(paper.ground?.(object, look) ?? []),
  wordOf(object),
];

/** The colour of a sheet as a word, at its lower edge. */
function wordOf({ at, size, angle, color, round, corners }: Paper): Shape {
  const isPlain = round !== true && corners === undefined;
  const letters = Math.min(LETTERS_MM, LETTERS_SHARE * Math.min(...size));
  const down = isPlain ? size[1] / 2 - 1.2 * letters : 0;
  return group(at, [group([0, down], [written(valueText(color), letters, paints[color].ink)])], angle);
}
