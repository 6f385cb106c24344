import { mdiArrowAll, mdiLock } from '@mdi/js';
import { rotationRad } from '#core/angle';
import type { Block } from '#scene/scene';
import { once } from '../../../../kit/state/memo';
import type { PlacedBlock } from '../../model/arena-model';
import type { Palette } from '../../model/palette';
import { toPx, type View } from '../../view/view-transform';
import { formOf, formPath, roomIn } from './shape-path';

/** A block of the scene as it lies at the start. */
export function placedBlock(block: Block): PlacedBlock {
  return {
    id: block.id,
    pose: { xMm: block.at[0], yMm: block.at[1], headingRad: rotationRad(block.angle) },
    ...formOf(block),
  };
}

/** Draws a block that can be pushed: light, thick frame, four arrows. */
export function drawMovableBlock(
  context: CanvasRenderingContext2D,
  view: View,
  block: PlacedBlock,
  held: boolean,
  palette: Palette,
): void {
  const { at, acrossMm: short } = roomIn(block);
  const frame = Math.min(3, short * 0.09);
  const radius = Math.min(5, short / 6);
  inFrameOf(context, view, block, held, radius, () => {
    context.fillStyle = palette.movable;
    formPath(context, block, frame / 2, radius);
    context.fill();
    context.fillStyle = palette.movableLight;
    formPath(context, block, frame * 1.6, radius * 0.7);
    context.fill();
    context.strokeStyle = palette.movableInk;
    context.lineWidth = frame;
    formPath(context, block, frame / 2, radius);
    context.stroke();
    context.translate(at.x, at.y);
    drawIcon(context, icons().arrows, short * 0.66, palette.movableInk, view);
  });
}

/** Draws a block that stays where it is: dark, diagonal stripes, a lock. */
export function drawFixedBlock(
  context: CanvasRenderingContext2D,
  view: View,
  block: PlacedBlock,
  palette: Palette,
): void {
  const { x: width, y: height } = block.sizeMm;
  const { at, acrossMm: short } = roomIn(block);
  const frame = Math.min(3, short * 0.08);
  const radius = Math.min(3, short / 8);
  inFrameOf(context, view, block, false, radius, () => {
    context.fillStyle = palette.fixed;
    formPath(context, block, 0, radius);
    context.fill();
    context.save();
    context.clip();
    drawStripes(context, width, height, Math.max(9, 5 / view.pxPerMm));
    context.restore();
    context.strokeStyle = palette.fixedEdge;
    context.lineWidth = frame;
    formPath(context, block, frame / 2, radius * 0.7);
    context.stroke();
    context.translate(at.x, at.y);
    if (short * view.pxPerMm < 11) return;
    context.fillStyle = palette.fixed;
    context.beginPath();
    context.arc(0, 0, short * 0.28, 0, 2 * Math.PI);
    context.fill();
    drawIcon(context, icons().lock, short * 0.4, palette.fixedInk, view);
  });
}

/** Paints in the block's own frame, in mm, y down; its shadow first: a filled path, by default around the block. */
export function inFrameOf(
  context: CanvasRenderingContext2D,
  view: View,
  block: PlacedBlock,
  held: boolean,
  radius: number,
  paint: () => void,
  shade: () => void = () => formPath(context, block, 0, radius),
): void {
  const at = toPx(view, { x: block.pose.xMm, y: block.pose.yMm });
  const lift = (held ? 3 : 1) * Math.min(3, Math.max(1, 2.4 * view.pxPerMm));
  const size = view.pxPerMm * (held ? 1.03 : 1);
  for (const layer of ['shadow', 'block'] as const) {
    context.save();
    context.translate(at.x + (layer === 'shadow' ? lift * 0.6 : 0), at.y + (layer === 'shadow' ? lift : 0));
    context.rotate(-block.pose.headingRad);
    context.scale(size, size);
    if (layer === 'block') paint();
    else {
      context.fillStyle = 'rgba(0, 0, 0, 0.2)';
      shade();
      context.fill();
    }
    context.restore();
  }
}

function drawStripes(context: CanvasRenderingContext2D, width: number, height: number, pitch: number): void {
  const reach = width / 2 + height / 2;
  const step = pitch * Math.SQRT2;
  context.strokeStyle = 'rgba(255, 255, 255, 0.4)';
  context.lineWidth = pitch * 0.36;
  context.beginPath();
  for (let x = -reach - step / 2; x <= reach + step; x += step) {
    context.moveTo(x - height / 2 - pitch, height / 2 + pitch);
    context.lineTo(x + height / 2 + pitch, -height / 2 - pitch);
  }
  context.stroke();
}

/** An icon of 24 units in the middle, this many mm wide; nothing if it would be a mere dot. */
export function drawIcon(
  context: CanvasRenderingContext2D,
  icon: Path2D,
  sizeMm: number,
  color: string,
  view: View,
): void {
  if (sizeMm * view.pxPerMm < 7) return;
  context.save();
  context.scale(sizeMm / 24, sizeMm / 24);
  context.translate(-12, -12);
  context.fillStyle = color;
  context.fill(icon);
  context.restore();
}

const icons = once(() => ({ arrows: new Path2D(mdiArrowAll), lock: new Path2D(mdiLock) }));
