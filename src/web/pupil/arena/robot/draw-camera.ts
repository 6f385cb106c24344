import type { CameraState } from '#robots/robot';
import type { Palette } from '../model/palette';
import { boxAround, unionOf, type PxBox } from '../view/moving-window';
import { toPx, type View } from '../view/view-transform';
import { withAlpha } from './draw-cone';

/** The area of what a camera sees of the floor, in CSS px. */
export const sightBox = ({ sightMm, fromMm }: CameraState, view: View): PxBox =>
  unionOf([fromMm, ...sightMm].map((place) => boxAround(toPx(view, place), 3)));

/** Draws what a camera sees of the floor, and dashed edges from its lens to there; under the robot. */
export function drawSight(
  context: CanvasRenderingContext2D,
  { sightMm, fromMm }: CameraState,
  view: View,
  palette: Palette,
): void {
  const [nearRight, farRight, farLeft, nearLeft] = sightMm.map((place) => toPx(view, place));
  const from = toPx(view, fromMm);
  if (!nearRight || !farRight || !farLeft || !nearLeft) return;
  context.fillStyle = withAlpha(palette.cone, 0.13);
  context.strokeStyle = palette.cone;
  context.lineWidth = 1.8;
  context.beginPath();
  context.moveTo(nearRight.x, nearRight.y);
  for (const { x, y } of [farRight, farLeft, nearLeft]) context.lineTo(x, y);
  context.closePath();
  context.fill();
  context.stroke();
  context.setLineDash([5, 5]);
  context.beginPath();
  for (const to of [nearRight, nearLeft]) {
    context.moveTo(from.x, from.y);
    context.lineTo(to.x, to.y);
  }
  context.stroke();
  context.setLineDash([]);
}
