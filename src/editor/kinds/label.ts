import type { Vec } from '#core/geometry';
import { boundsOf } from '#scene/kinds/index';
import { labelOutline } from '#scene/kinds/label';
import { sceneLimits, type Label, type Point } from '#scene/scene';
import { lengthField, placeFields, turnField } from '../object-fields';
import { boxed, boxSizeHandles, knobAbove, placed } from './box';
import { distanceMm, within } from '../plane';
import { hitWithin, longerSide, scaledPoint, type EditorKind } from './kind';

/** Words on the floor. */
export const label: EditorKind<Label> = {
  layer: 2,
  ...placed,
  ...hitWithin<Label>(labelOutline),
  extentMm: (label) => longerSide(boundsOf(label)),
  // Words keep their shape: they grow as far as the arena does on average.
  scaled: (label, about, { x, y }) => ({
    ...label,
    at: scaledPoint(label.at, about, { x, y }),
    height: Math.round(within(label.height * Math.sqrt(x * y), sceneLimits.labelMm)),
  }),
  handles: (label, reachMm) => [
    ...boxSizeHandles(boxOf(label), reachMm).filter(({ side }) => side?.[0] !== 0 && side?.[1] !== 0),
    knobAbove(label, label.height, reachMm),
  ],
  sized(label, side, place, drag) {
    const box = boxOf(label);
    const sized = boxed.sized(box, side, place, { ...drag, keeps: true, free: true });
    if (sized === null) return null;
    const height = Math.round(within((label.height * sized.size[1]) / box.size[1], sceneLimits.labelMm));
    return height === label.height ? null : { ...label, at: sized.at, height };
  },
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

/** The box that a label fills, in whole mm. */
function boxOf(label: Label): Pick<Label, 'id' | 'at' | 'angle'> & { readonly type: 'label'; readonly size: Point } {
  const [a, b, c] = labelOutline(label);
  const side = (from?: Vec, to?: Vec): number => (from && to ? Math.max(1, Math.round(distanceMm(from, to))) : 1);
  return { type: 'label', id: label.id, at: label.at, angle: label.angle, size: [side(a, b), side(b, c)] };
}

/** Words as a label holds them: one line, no spaces around, not too long. */
export const oneLine = (text: string): string =>
  text.replace(/\s+/gu, ' ').trim().slice(0, sceneLimits.labelCharacters).replace(HALF_A_SIGN, '').trim();

/** Half of a character of two UTF-16 units that was cut in the middle. */
const HALF_A_SIGN = /[\uD800-\uDBFF]$/u;
