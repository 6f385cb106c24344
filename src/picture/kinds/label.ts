import { rotationRad } from '#core/angle';
import type { Vec } from '#core/geometry';
import type { Label } from '#scene/scene';

import type { Look } from '../look';
import { group, type Shape } from '../shapes';
import type { PictureKind } from './kind';

/** Words on the floor. */
export const label: PictureKind<Label> = {
  mark: labelShapes,
  paper: labelShapes,
  frame: (label) => ({
    at: { x: label.at[0], y: label.at[1] },
    angleRad: rotationRad(label.angle),
    size: labelSize(label),
  }),
};

/** Height of a capital in parts of the size of its font, for usual sans-serif fonts. */
export const CAPITAL = 0.715;

function labelShapes({ at, text, height, angle }: Label, { colors, px }: Look): readonly Shape[] {
  const size = height / CAPITAL;
  if (size < 2 * px) return [];
  const rim = { color: colors.floor, width: Math.max(2 * px, size * 0.16) };
  return [
    group(
      at,
      [{ form: 'words', text, at: [0, height / 2], from: 'middle', size, weight: 600, fill: colors.label, rim }],
      angle,
    ),
  ];
}

/** Width of an average letter in parts of the height of capitals. */
const LETTER = 0.83;

/** Extent of the words of a label along and across them, in mm; good enough to point at. */
function labelSize({ text, height }: { readonly text: string; readonly height: number }): Vec {
  return { x: Math.max(1, text.length) * height * LETTER, y: height / CAPITAL };
}
