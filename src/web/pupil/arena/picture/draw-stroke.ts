import { needsRim, RIM_PX } from '#picture/kinds/stroke';
import type { Stroke } from '#scene/scene';
import { lastMadeOf } from '#core/memo';
import type { Palette } from '../model/palette';
import type { View } from '../view/view-transform';

/** Points nearer to each other than this, in px, are drawn as one. */
const NEAR_PX = 0.6;

/** The step of a zoom in factors of 2: a line's path is reused within one. */
export const pathStep = (pxPerMm: number): number => Math.ceil(Math.log2(Math.max(pxPerMm, 1 / 64)));

/** Draws a line with round ends and joints. Its path is kept for the next time. */
export function drawStroke(context: CanvasRenderingContext2D, view: View, stroke: Stroke, palette: Palette): void {
  const path = pathOf(stroke, pathStep(view.pxPerMm));
  context.save();
  context.translate(view.leftPx, view.bottomPx);
  context.scale(view.pxPerMm, -view.pxPerMm);
  context.lineCap = 'round';
  context.lineJoin = 'round';
  if (needsRim(stroke)) {
    context.strokeStyle = palette.strokeEdge;
    context.lineWidth = stroke.width + RIM_PX / view.pxPerMm;
    context.stroke(path);
  }
  context.strokeStyle = palette.strokes[stroke.color];
  context.lineWidth = stroke.width;
  context.stroke(path);
  context.restore();
}

/** A line made ready for a zoom: `step` as of `pathStep`. */
const pathOf = lastMadeOf((stroke: Stroke, step: number): Path2D => {
  const path = new Path2D();
  thinned(stroke.points, NEAR_PX / 2 ** step).forEach(([x, y], i) => {
    if (i === 0) path.moveTo(x, y);
    path.lineTo(x, y);
  });
  return path;
});

/** The points, without those nearer than this many mm to the previous one; both ends stay. */
export function thinned(points: Stroke['points'], nearMm: number): Stroke['points'] {
  const kept: (readonly [number, number])[] = [];
  points.forEach((point, i) => {
    const before = kept[kept.length - 1];
    const isNear =
      before !== undefined && Math.abs(point[0] - before[0]) < nearMm && Math.abs(point[1] - before[1]) < nearMm;
    if (!isNear || i === points.length - 1) kept.push(point);
  });
  return kept;
}
