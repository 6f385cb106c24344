import { mdiRotateRight } from '@mdi/js';
import { degOf } from '#core/angle';
import type { Pose, Vec } from '#core/geometry';
import { shownLanguage } from '../../../kit/i18n';
import { numberText } from '../../../kit/i18n/number-text';
import { once } from '#core/memo';
import { drawPill } from '../picture/draw-pill';
import { normalAngle } from './hand-gesture';
import type { Palette } from '../model/palette';
import { toPx, type CanvasSize, type View } from '../view/view-transform';

/** The ring around the robot, by which it is turned. */
export interface Ring {
  readonly pose: Pose;
  readonly radiusPx: number;
  readonly knobPx: Vec;
  /** A pointer is turning it. */
  readonly turning: boolean;
}

const rotateIcon = once(() => new Path2D(mdiRotateRight));

/** Draws the ring and its knob. */
export function drawRing(context: CanvasRenderingContext2D, view: View, ring: Ring, palette: Palette): void {
  const centre = toPx(view, { x: ring.pose.xMm, y: ring.pose.yMm });
  context.lineWidth = 5;
  context.strokeStyle = 'rgba(255, 255, 255, 0.75)';
  circle(context, centre, ring.radiusPx);
  context.stroke();
  context.lineWidth = ring.turning ? 2.5 : 1.75;
  context.strokeStyle = palette.hand;
  if (!ring.turning) context.setLineDash([2, 6]);
  context.lineCap = 'round';
  circle(context, centre, ring.radiusPx);
  context.stroke();
  context.setLineDash([]);
  context.lineCap = 'butt';
  context.save();
  context.shadowColor = 'rgba(0, 0, 0, 0.3)';
  context.shadowBlur = 5;
  context.shadowOffsetY = 1;
  context.fillStyle = ring.turning ? palette.hand : palette.handGround;
  circle(context, ring.knobPx, 13);
  context.fill();
  context.restore();
  context.lineWidth = 2;
  context.strokeStyle = palette.hand;
  circle(context, ring.knobPx, 12);
  context.stroke();
  context.save();
  context.translate(ring.knobPx.x, ring.knobPx.y);
  context.scale(0.64, 0.64);
  context.translate(-12, -12);
  context.fillStyle = ring.turning ? palette.handGround : palette.hand;
  context.fill(rotateIcon());
  context.restore();
}

/** Labels a held thing with its place in cm, or with its heading in degrees while it is turned. */
export function drawHeldPose(
  context: CanvasRenderingContext2D,
  view: View,
  pose: Pose,
  turning: boolean,
  distancePx: number,
  canvas: CanvasSize,
  palette: Palette,
): void {
  const at = toPx(view, { x: pose.xMm, y: pose.yMm });
  const above = at.y - distancePx > 20;
  const text = turning ? headingLabel(pose.headingRad) : placeLabel(pose);
  drawPill(context, text, { x: at.x, y: above ? at.y - distancePx : at.y + distancePx }, canvas, palette);
}

/** A heading in whole degrees, −179 … 180. */
export function headingLabel(headingRad: number): string {
  const deg = Math.round(degOf(normalAngle(headingRad)));
  return `${String(deg === -180 ? 180 : deg).replace('-', '−')}°`;
}

/** A place in cm, to the mm: "30.5 | 45 cm". */
export function placeLabel(pose: Pose): string {
  const cm = (mm: number): string => numberText(Math.round(mm) / 10, shownLanguage());
  return `${cm(pose.xMm)} | ${cm(pose.yMm)} cm`;
}

function circle(context: CanvasRenderingContext2D, at: Vec, radius: number): void {
  context.beginPath();
  context.arc(at.x, at.y, radius, 0, 2 * Math.PI);
}
