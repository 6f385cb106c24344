import type { Pose } from '#core/geometry';
import { shownLanguage } from '../../../kit/i18n';
import { numberText } from '../../../kit/i18n/number-text';
import { drawPill } from '../picture/draw-pill';
import { boxAround, unionOf, type PxBox } from '../view/moving-window';
import type { Palette } from '../model/palette';
import type { RotationCentre } from './rotation-centre';
import { toPx, type CanvasSize, type View } from '../view/view-transform';

/** Room for the label, in px. */
const LABEL_PX = 52;

/** Formats the radius for its label: `r = 15 cm`; below 10 cm with a decimal. */
export function radiusLabel(radiusMm: number): string {
  const cm = radiusMm < 99.5 ? Math.round(radiusMm) / 10 : Math.round(radiusMm / 10);
  return `r = ${numberText(cm, shownLanguage())} cm`;
}

/** The area in which it is drawn, in px. */
export function centreBox(centre: RotationCentre, pose: Pose, view: View): PxBox {
  return unionOf([
    boxAround(toPx(view, centre.atMm), LABEL_PX),
    boxAround(toPx(view, { x: pose.xMm, y: pose.yMm }), 4),
  ]);
}

/** Marks the point around which the robot turns, with the radius that leads to the middle of its axle. */
export function drawCentre(
  context: CanvasRenderingContext2D,
  view: View,
  centre: RotationCentre,
  pose: Pose,
  canvas: CanvasSize,
  palette: Palette,
): void {
  const at = toPx(view, centre.atMm);
  const axle = toPx(view, { x: pose.xMm, y: pose.yMm });
  const twice = (stroke: () => void, width: number): void => {
    for (const [color, lineWidth] of [
      [palette.traceCasing, width + 2.6],
      [palette.centre, width],
    ] as const) {
      context.strokeStyle = color;
      context.lineWidth = lineWidth;
      stroke();
    }
  };
  context.save();
  context.lineCap = 'round';
  context.setLineDash([1, 6]);
  twice(() => {
    context.beginPath();
    context.moveTo(at.x, at.y);
    context.lineTo(axle.x, axle.y);
    context.stroke();
  }, 2.4);
  context.setLineDash([]);
  twice(() => {
    context.beginPath();
    context.moveTo(at.x - 10, at.y);
    context.lineTo(at.x + 10, at.y);
    context.moveTo(at.x, at.y - 10);
    context.lineTo(at.x, at.y + 10);
    context.stroke();
    context.beginPath();
    context.arc(at.x, at.y, 5.5, 0, 2 * Math.PI);
    context.stroke();
  }, 2);
  context.restore();
  const below = at.y + 30 < canvas.heightPx - 16 && at.y >= axle.y;
  drawPill(context, radiusLabel(centre.radiusMm), { x: at.x, y: at.y + (below ? 30 : -30) }, canvas, palette);
}
