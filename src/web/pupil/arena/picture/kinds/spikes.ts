import { mdiAlert } from '@mdi/js';
import { rotationRad } from '#core/angle';
import type { Pose, Vec } from '#core/geometry';
import type { Mover, Spikes } from '#scene/scene';
import { once } from '../../../../kit/state/memo';
import type { Form, PlacedBlock } from '../../model/arena-model';
import type { Outline } from '#scene/outline';
import { drawIcon, inFrameOf } from './block';
import { formOf, inset, linesPath, polygonPath, roomIn } from './shape-path';
import type { Palette } from '../../model/palette';
import type { View } from '../../view/view-transform';

/** A box of the course in its place at the start. */
export function placedBox(box: Spikes | Mover): PlacedBlock {
  return { id: box.id, pose: startPose(box), ...formOf(box) };
}

const startPose = ({ at, angle }: Spikes | Mover): Pose => ({
  xMm: at[0],
  yMm: at[1],
  headingRad: rotationRad(angle),
});

/** Draws spikes: teeth around a dark body with a warning sign. */
export function drawSpikes(context: CanvasRenderingContext2D, view: View, spikes: Spikes, palette: Palette): void {
  const box = placedBox(spikes);
  const { at, acrossMm: short } = roomIn(box);
  const paint = (): void => {
    drawTeeth(context, box, palette);
    context.translate(at.x, at.y);
    drawIcon(context, alertIcon(), short * 0.46, palette.spikesInk, view);
  };
  inFrameOf(context, view, box, false, 2, paint, () => teethPath(context, box));
}

/** How far teeth stand out, in mm. */
export const toothMm = (form: Form): number => Math.min(9, roomIn(form).acrossMm * 0.18);

/** Begins a path around teeth about the origin. */
export function teethPath(context: CanvasRenderingContext2D, form: Form): void {
  context.beginPath();
  linesPath(context, teeth(form));
}

/** Draws teeth about the origin. */
export function drawTeeth(context: CanvasRenderingContext2D, form: Form, palette: Palette): void {
  teethPath(context, form);
  context.fillStyle = palette.spikes;
  context.fill();
  context.strokeStyle = palette.spikesInk;
  context.lineWidth = toothMm(form) * 0.12;
  context.lineJoin = 'miter';
  context.stroke();
}

/** The outline of a form with teeth all around, about the origin, y down: the tips lie on the form's edge. */
export function teeth(form: Form): readonly Vec[] {
  const depth = toothMm(form);
  if (form.corners) return teethOfPolygon(polygonPath(form), depth);
  return form.round === true ? teethOfEllipse(form.sizeMm, depth) : teethOfBox(form.sizeMm, depth);
}

/** Teeth side by side are so many times as wide as deep. */
const WIDE = 1.25;

function teethOfPolygon(outline: Outline, depth: number): readonly Vec[] {
  const feet = inset(outline, depth);
  return outline.flatMap((from, index) => {
    const next = (index + 1) % outline.length;
    const [to, foot, nextFoot] = [outline[next] ?? from, feet[index] ?? from, feet[next] ?? from];
    const count = Math.max(1, Math.round(Math.hypot(to.x - from.x, to.y - from.y) / (depth * WIDE)));
    return Array.from({ length: 2 * count }, (_, half) =>
      half % 2 === 0 ? between(foot, nextFoot, half / (2 * count)) : between(from, to, half / (2 * count)),
    );
  });
}

const between = (a: Vec, b: Vec, share: number): Vec => ({
  x: a.x + (b.x - a.x) * share,
  y: a.y + (b.y - a.y) * share,
});

function teethOfEllipse(size: Vec, depth: number): readonly Vec[] {
  const count = Math.max(8, Math.round((Math.PI * (size.x + size.y)) / 2 / (depth * WIDE)));
  return Array.from({ length: 2 * count }, (_, half) => {
    const rad = (half * Math.PI) / count;
    const inwards = half % 2 === 0 ? depth : 0;
    return { x: (size.x / 2 - inwards) * Math.cos(rad), y: (size.y / 2 - inwards) * Math.sin(rad) };
  });
}

function teethOfBox(size: Vec, depth: number): readonly Vec[] {
  const half = { x: size.x / 2, y: size.y / 2 };
  const points: Vec[] = [];
  /** Teeth along one side: `at` leads from its start along it and from its foot outward. */
  const side = (length: number, at: (along: number, out: number) => Vec): void => {
    const inner = length - 2 * depth;
    const count = Math.max(1, Math.round(inner / (depth * WIDE)));
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

const alertIcon = once(() => new Path2D(mdiAlert));
