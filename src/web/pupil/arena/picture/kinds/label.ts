import { rotationRad } from '#core/angle';
import type { Vec } from '#core/geometry';
import type { Label } from '#scene/scene';
import { canvasFont, type Palette } from '../../model/palette';
import { toPx, type View } from '../../view/view-transform';

/** Height of a capital in parts of the size of its font, for the sans-serif fonts of `canvasFont`. */
export const CAPITAL = 0.715;

/** Draws words on the floor, with a rim of floor so that they can be read on a line as well. */
export function drawLabel(context: CanvasRenderingContext2D, view: View, label: Label, palette: Palette): void {
  const at = toPx(view, { x: label.at[0], y: label.at[1] });
  const size = (label.height * view.pxPerMm) / CAPITAL;
  if (size < 2) return;
  context.save();
  context.translate(at.x, at.y);
  context.rotate(-rotationRad(label.angle));
  context.font = `600 ${size.toFixed(2)}px ${canvasFont}`;
  context.textAlign = 'center';
  context.textBaseline = 'alphabetic';
  context.lineJoin = 'round';
  context.lineWidth = Math.max(2, size * 0.16);
  context.strokeStyle = palette.floor;
  context.fillStyle = palette.label;
  context.strokeText(label.text, 0, (size * CAPITAL) / 2);
  context.fillText(label.text, 0, (size * CAPITAL) / 2);
  context.restore();
}

/** Width of an average letter in parts of the height of capitals. */
const LETTER = 0.83;

/** Extent of the words of a label along and across them, in mm; good enough to point at. */
export function labelSize({ text, height }: { readonly text: string; readonly height: number }): Vec {
  return { x: Math.max(1, text.length) * height * LETTER, y: height / CAPITAL };
}
