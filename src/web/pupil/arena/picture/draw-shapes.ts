import { radOf } from '#core/angle';
import { memo } from '#core/memo';
import type { Look } from '#picture/look';
import type { Geometry, Paint, Shape, Words } from '#picture/shapes';
import type { Point } from '#scene/scene';
import { shownLanguage } from '../../../kit/i18n';
import { numberText } from '../../../kit/i18n/number-text';
import { canvasFont, type Palette } from '../model/palette';
import type { View } from '../view/view-transform';

/** How a course looks in a view of the arena. */
export const lookOf = ({ pxPerMm }: View, colors: Palette): Look => ({
  ...{ colors, px: 1 / pxPerMm },
  seconds: (seconds) => numberText(seconds, shownLanguage()),
});

/** Draws shapes in their places in the arena. */
export function drawShapes(context: CanvasRenderingContext2D, view: View, shapes: readonly Shape[]): void {
  if (shapes.length === 0) return;
  context.save();
  context.translate(view.leftPx, view.bottomPx);
  context.scale(view.pxPerMm, view.pxPerMm);
  for (const shape of shapes) drawShape(context, shape, -1);
  context.restore();
}

/** Draws a shape in mm, y down. `up`: sign of the y of its place; −1 for a place with y up. */
export function drawShape(context: CanvasRenderingContext2D, shape: Shape, up: 1 | -1 = 1): void {
  switch (shape.form) {
    case 'group':
      context.save();
      context.translate(shape.at[0], up * shape.at[1]);
      if (shape.turn !== 0) context.rotate(-radOf(shape.turn));
      for (const one of shape.inside) drawShape(context, one);
      return context.restore();
    case 'words':
      return drawWords(context, shape);
    case 'icon':
      context.save();
      context.scale(shape.across / 24, shape.across / 24);
      context.translate(-12, -12);
      paint(context, shape, iconOf(shape.path));
      return context.restore();
    default:
      pathOf(context, shape, up);
      return paint(context, shape);
  }
}

/** Begins a path around a shape, in mm, y down. */
export function pathOf(context: CanvasRenderingContext2D, shape: Geometry, up: 1 | -1 = 1): void {
  context.beginPath();
  if (shape.form === 'lines') for (const line of shape.lines) linePath(context, line, shape.isClosed === true, up);
  else if (shape.form === 'ellipse')
    context.ellipse(shape.at[0], up * shape.at[1], shape.radii[0], shape.radii[1], 0, 0, 2 * Math.PI);
  else context.roundRect(shape.at[0], shape.at[1], shape.size[0], shape.size[1], shape.round);
}

/** Adds a line through places to a path. */
export function linePath(
  context: CanvasRenderingContext2D,
  line: readonly Point[],
  isClosed = true,
  up: 1 | -1 = 1,
): void {
  line.forEach(([x, y], i) => (i === 0 ? context.moveTo(x, up * y) : context.lineTo(x, up * y)));
  if (isClosed) context.closePath();
}

function paint(context: CanvasRenderingContext2D, shape: Paint, path?: Path2D): void {
  const alpha = context.globalAlpha;
  if (shape.opacity !== undefined) context.globalAlpha = alpha * shape.opacity;
  if (shape.fill !== undefined) {
    context.fillStyle = shape.fill;
    if (path) context.fill(path);
    else context.fill();
  }
  if (shape.stroke !== undefined) {
    context.strokeStyle = shape.stroke;
    context.lineWidth = shape.width ?? 1;
    context.lineCap = shape.cap ?? 'butt';
    context.lineJoin = shape.join ?? 'miter';
    context.setLineDash(shape.dash ? [...shape.dash] : []);
    context.lineDashOffset = shape.dashFrom ?? 0;
    if (path) context.stroke(path);
    else context.stroke();
  }
  context.globalAlpha = alpha;
}

function drawWords(context: CanvasRenderingContext2D, { text, at: [x, y], rim, ...words }: Words): void {
  context.font = `${String(words.weight)} ${words.size.toFixed(2)}px ${canvasFont}`;
  context.textAlign = words.from === 'middle' ? 'center' : 'left';
  context.textBaseline = 'alphabetic';
  if (rim) {
    context.setLineDash([]);
    context.lineJoin = 'round';
    context.lineWidth = rim.width;
    context.strokeStyle = rim.color;
    context.strokeText(text, x, y);
  }
  context.fillStyle = words.fill;
  context.fillText(text, x, y, words.mostMm);
}

/** Made when first drawn: `Path2D` exists in browsers only. */
const iconOf = memo((path: string) => new Path2D(path));
