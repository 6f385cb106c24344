import type { Vec } from '#core/geometry';
import type { CameraState } from '#robots/robot';
import type { Palette } from '../model/palette';
import { boxAround, unionOf, type PxBox } from '../view/moving-window';
import { toPx, type View } from '../view/view-transform';
import { withAlpha } from './draw-cone';

/** The area of what a camera sees of the floor, in CSS px. */
export const sightBox = (camera: CameraState, view: View): PxBox =>
  unionOf([camera.fromMm, ...sightOutline(camera)].map((place) => boxAround(toPx(view, place), 3)));

/**
 * The outline of the floor that a camera sees, in the world: near right, the ends from right to left, near left. Where a thing
 * is nearer than the floor that it sees first, the outline has no depth there; with things all over, its line is at them.
 */
export function sightOutline({ fromMm, headingRad, sight, endsMm }: CameraState): readonly Vec[] {
  const { nearMm, nearSlope, farSlope } = sight;
  const [cos, sin] = [Math.cos(headingRad), Math.sin(headingRad)];
  const at = (x: number, y: number): Vec => ({
    x: fromMm.x + x * cos - y * sin,
    y: fromMm.y + x * sin + y * cos,
  });
  const last = endsMm.length - 1;
  const firstMm = Math.min(nearMm, Math.max(0, ...endsMm));
  const ends = endsMm.map((end, part) => {
    const x = Math.max(firstMm, end);
    return at(x, x * farSlope * ((2 * part) / last - 1));
  });
  return [at(firstMm, -firstMm * nearSlope), ...ends, at(firstMm, firstMm * nearSlope)];
}

/** Draws what a camera sees of the floor, and dashed edges from its lens to there; under the robot. */
export function drawSight(context: CanvasRenderingContext2D, camera: CameraState, view: View, palette: Palette): void {
  const [nearRight, ...others] = sightOutline(camera).map((place) => toPx(view, place));
  const nearLeft = others[others.length - 1];
  const from = toPx(view, camera.fromMm);
  if (!nearRight || !nearLeft) return;
  context.fillStyle = withAlpha(palette.cone, 0.13);
  context.strokeStyle = palette.cone;
  context.lineWidth = 1.8;
  context.beginPath();
  context.moveTo(nearRight.x, nearRight.y);
  for (const { x, y } of others) context.lineTo(x, y);
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
