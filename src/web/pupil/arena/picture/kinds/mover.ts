import type { Pose, Vec } from '#core/geometry';
import { isZone } from '#scene/kinds/zone';
import { stopsOf } from '#scene/kinds/mover-way';
import type { Mover, SceneObject } from '#scene/scene';
import { memo } from '../../../../kit/state/memo';
import { shownLanguage } from '../../../../kit/i18n';
import { numberText } from '../../../../kit/i18n/number-text';
import { canvasFont, type Palette } from '../../model/palette';
import { toPx, type View } from '../../view/view-transform';
import { drawIcon, inFrameOf } from './block';
import { formOf, formPath } from './shape-path';
import { closedWay, moverSign, moverSignRad } from './mover-sign';
import { drawTeeth, placedBox, teethPath, toothMm } from './spikes';

/** Draws a moving obstacle where it is now: yellow, with the sign of what it does; with teeth if it is spiked. */
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
    context.rotate(box.pose.headingRad - moverSignRad(mover));
    drawIcon(context, iconOf(mover), short * 0.72, palette.moverInk, view);
  };
  inFrameOf(context, view, box, false, radius, paint, mover.spiked ? () => teethPath(context, box) : undefined);
}

/**
 * Draws the way of a moving obstacle on the floor: dashes from stop to stop, its outline where it turns round, and how
 * long it waits. Of one that chases only so far as it looks, and to which zone.
 */
export function drawTrack(
  context: CanvasRenderingContext2D,
  view: View,
  mover: Mover,
  palette: Palette,
  around: readonly SceneObject[] = [],
): void {
  const line = Math.max(1.5, 2.5 * view.pxPerMm);
  context.save();
  context.strokeStyle = palette.moverInk;
  context.globalAlpha *= 0.75;
  context.lineWidth = line;
  if (mover.chases) drawWatch(context, view, mover, around, line);
  else drawStops(context, view, mover, line, palette);
  context.restore();
}

function drawStops(context: CanvasRenderingContext2D, view: View, mover: Mover, line: number, palette: Palette): void {
  const stops = stopsOf(mover);
  const [last] = stops.slice(-1);
  if (last === undefined || stops.length < 2) return;
  context.setLineDash([3 * line, 2.4 * line]);
  context.beginPath();
  for (const [x, y] of closedWay(
    mover,
    stops.map(({ at }) => at),
  )) {
    const at = toPx(view, { x, y });
    context.lineTo(at.x, at.y);
  }
  context.stroke();
  context.setLineDash([]);
  for (const [index, { at, wait }] of [...stops.entries()].reverse()) {
    const px = toPx(view, { x: at[0], y: at[1] });
    context.fillStyle = palette.floor;
    context.beginPath();
    context.arc(px.x, px.y, (index === 0 ? 1.6 : 2.6) * line, 0, 2 * Math.PI);
    context.fill();
    context.stroke();
    if (wait > 0) drawWait(context, px, wait, Math.min(...mover.size) * view.pxPerMm, palette);
  }
  if (!mover.loops) drawEnd(context, view, { ...mover, at: last.at }, line);
}

/** Beside the obstacle, which may cover its stop. */
function drawWait(context: CanvasRenderingContext2D, at: Vec, seconds: number, sidePx: number, palette: Palette): void {
  context.save();
  context.globalAlpha = 1;
  context.font = `600 12px ${canvasFont}`;
  context.textAlign = 'left';
  context.textBaseline = 'middle';
  context.lineJoin = 'round';
  context.lineWidth = 4;
  context.strokeStyle = palette.floor;
  context.fillStyle = palette.moverInk;
  const text = `${numberText(seconds, shownLanguage())} s`;
  context.strokeText(text, at.x + sidePx / 2 + 6, at.y - sidePx / 2 - 6);
  context.fillText(text, at.x + sidePx / 2 + 6, at.y - sidePx / 2 - 6);
  context.restore();
}

/** The outline where it turns round. */
function drawEnd(context: CanvasRenderingContext2D, view: View, mover: Mover, line: number): void {
  const box = placedBox(mover);
  const at = toPx(view, { x: box.pose.xMm, y: box.pose.yMm });
  context.translate(at.x, at.y);
  context.rotate(-box.pose.headingRad);
  context.scale(view.pxPerMm, view.pxPerMm);
  context.lineWidth = line / view.pxPerMm;
  context.setLineDash([2.4 * context.lineWidth, 2 * context.lineWidth]);
  formPath(context, formOf(mover), 0, 4);
  context.stroke();
}

/** A dotted circle as far as it notices robots, and a dotted line to the zone that it guards. */
function drawWatch(
  context: CanvasRenderingContext2D,
  view: View,
  { at, chases }: Mover,
  around: readonly SceneObject[],
  line: number,
): void {
  const middle = toPx(view, { x: at[0], y: at[1] });
  const zone = around.filter(isZone).find(({ id }) => id === chases?.zone);
  context.lineCap = 'round';
  context.setLineDash([0, 3 * line]);
  context.beginPath();
  if (chases?.reach !== undefined) context.arc(middle.x, middle.y, chases.reach * view.pxPerMm, 0, 2 * Math.PI);
  if (zone !== undefined) {
    const guarded = toPx(view, { x: zone.at[0], y: zone.at[1] });
    context.moveTo(middle.x, middle.y);
    context.lineTo(guarded.x, guarded.y);
  }
  context.stroke();
}

const icon = memo((sign: string) => new Path2D(sign));
const iconOf = (mover: Mover): Path2D => icon(moverSign(mover));
