import { mdiAlert, mdiArrowLeftRightBold } from '@mdi/js';
import type { Pose, Vec } from '#core/geometry';
import type { Mover, Spikes } from '#scene/scene';
import type { PlacedBlock } from './arena-model';
import { drawIcon, inFrameOf, roundRect } from './draw-blocks';
import type { Palette } from './palette';
import { toPx, type View } from '../view/view-transform';

/** A box of the course in its place at the start. */
export function placedBox(box: Spikes | Mover): PlacedBlock {
  return { id: box.id, pose: startPose(box), sizeMm: { x: box.size[0], y: box.size[1] } };
}

const startPose = ({ at, turn }: Spikes | Mover): Pose => ({
  xMm: at[0],
  yMm: at[1],
  headingRad: (turn * Math.PI) / 4,
});

/** Draws spikes: teeth around a dark body with a warning sign. */
export function drawSpikes(context: CanvasRenderingContext2D, view: View, spikes: Spikes, palette: Palette): void {
  const box = placedBox(spikes);
  const short = Math.min(box.sizeMm.x, box.sizeMm.y);
  const paint = (): void => {
    drawTeeth(context, box.sizeMm, palette);
    drawIcon(context, icons().alert, short * 0.46, palette.spikesInk, view);
  };
  inFrameOf(context, view, box, false, 2, paint, () => teethPath(context, box.sizeMm));
}

/** How far teeth stand out, in mm. */
const toothMm = (size: Vec): number => Math.min(9, Math.min(size.x, size.y) * 0.18);

function teethPath(context: CanvasRenderingContext2D, size: Vec): void {
  context.beginPath();
  teeth(size).forEach(({ x, y }, i) => {
    if (i === 0) context.moveTo(x, y);
    else context.lineTo(x, y);
  });
  context.closePath();
}

function drawTeeth(context: CanvasRenderingContext2D, size: Vec, palette: Palette): void {
  teethPath(context, size);
  context.fillStyle = palette.spikes;
  context.fill();
  context.strokeStyle = palette.spikesInk;
  context.lineWidth = toothMm(size) * 0.12;
  context.lineJoin = 'miter';
  context.stroke();
}

/** The outline of a box with teeth all around, about the origin: the tips lie on the box's edge. */
export function teeth(size: Vec): readonly Vec[] {
  const depth = toothMm(size);
  const half = { x: size.x / 2, y: size.y / 2 };
  const points: Vec[] = [];
  /** Teeth along one side: `at` leads from its start along it and from its foot outward. */
  const side = (length: number, at: (along: number, out: number) => Vec): void => {
    const inner = length - 2 * depth;
    const count = Math.max(1, Math.round(inner / (depth * 1.25)));
    points.push(at(depth, 0));
    for (let i = 0; i < count; i += 1) {
      points.push(at(depth + ((i + 0.5) * inner) / count, depth));
      points.push(at(depth + ((i + 1) * inner) / count, 0));
    }
  };
  const [w, h] = [half.x, half.y];
  side(size.x, (along, out) => ({ x: -w + along, y: -h + depth - out }));
  side(size.y, (along, out) => ({ x: w - depth + out, y: -h + along }));
  side(size.x, (along, out) => ({ x: w - along, y: h - depth + out }));
  side(size.y, (along, out) => ({ x: -w + depth - out, y: h - along }));
  return points;
}

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
  const { x: width, y: height } = box.sizeMm;
  const depth = mover.spiked ? toothMm(box.sizeMm) : 0;
  const inner = { x: width - 2 * depth, y: height - 2 * depth };
  const short = Math.min(inner.x, inner.y);
  const frame = Math.min(3, short * 0.09);
  const radius = mover.spiked ? 1.5 : Math.min(5, short / 6);
  const paint = (): void => {
    if (mover.spiked) drawTeeth(context, box.sizeMm, palette);
    context.fillStyle = palette.mover;
    roundRect(context, inner.x - frame, inner.y - frame, radius);
    context.fill();
    context.fillStyle = palette.moverLight;
    roundRect(context, inner.x - frame * 3.2, inner.y - frame * 3.2, radius * 0.7);
    context.fill();
    context.strokeStyle = palette.moverInk;
    context.lineWidth = frame;
    roundRect(context, inner.x - frame, inner.y - frame, radius);
    context.stroke();
    context.rotate(box.pose.headingRad - wayRad(mover));
    drawIcon(context, icons().arrows, short * 0.72, palette.moverInk, view);
  };
  inFrameOf(context, view, box, false, radius, paint, mover.spiked ? () => teethPath(context, box.sizeMm) : undefined);
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
  context.rotate((-mover.turn * Math.PI) / 4);
  context.scale(view.pxPerMm, view.pxPerMm);
  context.lineWidth = line / view.pxPerMm;
  context.setLineDash([2.4 * context.lineWidth, 2 * context.lineWidth]);
  roundRect(context, mover.size[0], mover.size[1], 4);
  context.stroke();
  context.restore();
}

let shared: { readonly alert: Path2D; readonly arrows: Path2D } | null = null;

/** Made when first drawn: `Path2D` exists in browsers only. */
function icons(): { readonly alert: Path2D; readonly arrows: Path2D } {
  shared ??= { alert: new Path2D(mdiAlert), arrows: new Path2D(mdiArrowLeftRightBold) };
  return shared;
}
