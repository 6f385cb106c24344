import { mdiArrowLeftRightBold } from '@mdi/js';
import { rotationRad } from '#core/angle';
import type { Pose } from '#core/geometry';
import type { Mover } from '#scene/scene';
import type { Palette } from '../../model/palette';
import { toPx, type View } from '../../view/view-transform';
import { drawIcon, inFrameOf } from './block';
import { formOf, formPath } from './shape-path';
import { drawTeeth, placedBox, teethPath, toothMm } from './spikes';

/** Draws a moving obstacle where it is now: yellow, with an arrow along its path; with teeth if it is spiked. */
export function drawMover(
  context: CanvasRenderingContext2D,
  view: View,
  mover: Mover,
  pose: Pose | null,
  palette: Palette,
): void {
  const start = placedBox(mover);
  const box = pose === null ? start : { ...start, pose };
  const depth = mover.spiked ? toothMm(box) : 0;
  const short = Math.min(box.sizeMm.x, box.sizeMm.y) - 2 * depth;
  const frame = Math.min(3, short * 0.09);
  const radius = mover.spiked ? 1.5 : Math.min(5, short / 6);
  const paint = (): void => {
    if (mover.spiked) drawTeeth(context, box, palette);
    context.fillStyle = palette.mover;
    formPath(context, box, depth + frame / 2, radius);
    context.fill();
    context.fillStyle = palette.moverLight;
    formPath(context, box, depth + frame * 1.6, radius * 0.7);
    context.fill();
    context.strokeStyle = palette.moverInk;
    context.lineWidth = frame;
    formPath(context, box, depth + frame / 2, radius);
    context.stroke();
    context.rotate(box.pose.headingRad - wayRad(mover));
    drawIcon(context, arrowsIcon(), short * 0.72, palette.moverInk, view);
  };
  inFrameOf(context, view, box, false, radius, paint, mover.spiked ? () => teethPath(context, box) : undefined);
}

/** Direction of a mover's path, counter-clockwise from +x. */
const wayRad = ({ at, to }: Mover): number => Math.atan2(to[1] - at[1], to[0] - at[0]);

/** Draws the path of a moving obstacle on the floor: dashes, and its outline at the turning point. */
export function drawTrack(context: CanvasRenderingContext2D, view: View, mover: Mover, palette: Palette): void {
  const from = toPx(view, { x: mover.at[0], y: mover.at[1] });
  const to = toPx(view, { x: mover.to[0], y: mover.to[1] });
  const line = Math.max(1.5, 2.5 * view.pxPerMm);
  context.save();
  context.strokeStyle = palette.moverInk;
  context.globalAlpha *= 0.75;
  context.lineWidth = line;
  context.setLineDash([3 * line, 2.4 * line]);
  context.beginPath();
  context.moveTo(from.x, from.y);
  context.lineTo(to.x, to.y);
  context.stroke();
  for (const [end, radius] of [
    [to, 2.6 * line],
    [from, 1.6 * line],
  ] as const) {
    // prettier-ignore
    context.setLineDash([]);
    context.fillStyle = palette.floor;
    context.beginPath();
    context.arc(end.x, end.y, radius, 0, 2 * Math.PI);
    context.fill();
    context.stroke();
  }
  context.translate(to.x, to.y);
  context.rotate(-rotationRad(mover.angle));
  context.scale(view.pxPerMm, view.pxPerMm);
  context.lineWidth = line / view.pxPerMm;
  context.setLineDash([2.4 * context.lineWidth, 2 * context.lineWidth]);
  formPath(context, formOf(mover), 0, 4);
  context.stroke();
  context.restore();
}

let shared: Path2D | null = null;

/** Made when first drawn: `Path2D` exists in browsers only. */
const arrowsIcon = (): Path2D => (shared ??= new Path2D(mdiArrowLeftRightBold));
