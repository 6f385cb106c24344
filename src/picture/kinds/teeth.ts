import { exactCos, exactSin } from '#core/exact-math';
import type { Vec } from '#core/geometry';
import { lengthOf, type Outline } from '#scene/outline';

import { inset, pairs, polygonPath, signRoomIn, type Form } from '../form';
import type { Look } from '../look';
import type { Geometry, Shape } from '../shapes';

/** How far teeth stand out, in mm. */
export const toothMm = (form: Form): number => Math.min(9, signRoomIn(form).acrossMm * 0.18);

/** A form with teeth all around: its outline. */
export const toothedOutline = (form: Form): Geometry => ({
  form: 'lines',
  lines: [pairs(teeth(form))],
  isClosed: true,
});

/** A form with teeth all around, in the colours of spikes. */
export const toothed = (form: Form, { colors }: Look): Shape => ({
  ...toothedOutline(form),
  ...{ fill: colors.spikes, stroke: colors.spikesInk, width: toothMm(form) * 0.12 },
});

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
    const count = Math.max(1, Math.round(lengthOf(to.x - from.x, to.y - from.y) / (depth * WIDE)));
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
    return { x: (size.x / 2 - inwards) * exactCos(rad), y: (size.y / 2 - inwards) * exactSin(rad) };
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
