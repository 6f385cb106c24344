import { mdiAlert } from '@mdi/js';
import { rotationRad } from '#core/angle';
import type { Pose, Vec } from '#core/geometry';
import type { Mover, Spikes } from '#scene/scene';
import type { PlacedBlock } from '../../model/arena-model';
import { drawIcon, inFrameOf } from './block';
import type { Palette } from '../../model/palette';
import type { View } from '../../view/view-transform';

/** A box of the course in its place at the start. */
export function placedBox(box: Spikes | Mover): PlacedBlock {
  return { id: box.id, pose: startPose(box), sizeMm: { x: box.size[0], y: box.size[1] } };
}

const startPose = ({ at, angle }: Spikes | Mover): Pose => ({
  xMm: at[0],
  yMm: at[1],
  headingRad: rotationRad(angle),
});

/** Draws spikes: teeth around a dark body with a warning sign. */
export function drawSpikes(context: CanvasRenderingContext2D, view: View, spikes: Spikes, palette: Palette): void {
  const box = placedBox(spikes);
  const short = Math.min(box.sizeMm.x, box.sizeMm.y);
  const paint = (): void => {
    drawTeeth(context, box.sizeMm, palette);
    drawIcon(context, alertIcon(), short * 0.46, palette.spikesInk, view);
  };
  inFrameOf(context, view, box, false, 2, paint, () => teethPath(context, box.sizeMm));
}

/** How far teeth stand out, in mm. */
export const toothMm = (size: Vec): number => Math.min(9, Math.min(size.x, size.y) * 0.18);

/** Begins a path around teeth about the origin. */
export function teethPath(context: CanvasRenderingContext2D, size: Vec): void {
  context.beginPath();
  teeth(size).forEach(({ x, y }, i) => {
    if (i === 0) context.moveTo(x, y);
    else context.lineTo(x, y);
  });
  context.closePath();
}

/** Draws teeth about the origin. */
export function drawTeeth(context: CanvasRenderingContext2D, size: Vec, palette: Palette): void {
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

let shared: Path2D | null = null;

/** Made when first drawn: `Path2D` exists in browsers only. */
const alertIcon = (): Path2D => (shared ??= new Path2D(mdiAlert));
