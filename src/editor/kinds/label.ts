import { boundsOf } from '#scene/kinds/index';
import { labelOutline } from '#scene/kinds/label';
import { sceneLimits, type Label } from '#scene/scene';
import { lengthField, placeFields, turnField } from '../object-fields';
import { knobAbove, placed } from './box';
import { hitWithin, longerSide, type EditorKind } from './kind';

/** Words on the floor. */
export const label: EditorKind<Label> = {
  layer: 2,
  ...placed,
  ...hitWithin<Label>(labelOutline),
  extentMm: (label) => longerSide(boundsOf(label)),
  handles: (label, reachMm) => [knobAbove(label, label.height, reachMm)],
  fields: (label) => [
    {
      ...{ kind: 'text', name: 'text', value: label.text, maxCharacters: sceneLimits.labelCharacters },
      with: (text: string) => ({ ...label, text }),
    },
    ...placeFields(label, label.at, placed.moved),
    lengthField('letterHeight', label.height, sceneLimits.labelMm, 5, (height) => ({ ...label, height })),
    turnField(label),
  ],
  made: (id, at, _scene, { labelText, labelHeight }) => ({
    ...{ type: 'label', id, at, text: oneLine(labelText) || 'Text', height: labelHeight, angle: 0 },
  }),
};

/** Words as a label holds them: one line, no spaces around, not too long. */
export const oneLine = (text: string): string =>
  text.replace(/\s+/gu, ' ').trim().slice(0, sceneLimits.labelCharacters).replace(HALF_A_SIGN, '').trim();

/** Half of a character of two UTF-16 units that was cut in the middle. */
const HALF_A_SIGN = /[\uD800-\uDBFF]$/u;
