import { beginsOn } from '#scene/kinds/switching';
import { lengthOf } from '#scene/outline';
import type { Barrier } from '#scene/scene';

import type { Look } from '../look';
import { circle, type Shape } from '../shapes';
import type { PictureKind } from './kind';
import type { Switched } from './lamp';
import { inWallFrame, wallFrame, wallShape } from './wall';

/** Barriers: a red and white bar between two posts; open only the posts, and the place of the bar dashed. */
export const barrier: PictureKind<Barrier> = {
  body: (barrier, look) => [inWallFrame(barrier, shapes(barrier, look))],
  shade: (barrier, fill) => inWallFrame(barrier, [{ ...wallShape(barrier, 0), fill }]),
  frame: wallFrame,
};

const [RED, WHITE, POST] = ['#C0262D', '#FFFFFF', '#23272E'];

const isOpen = (barrier: Barrier & Switched): boolean => barrier.isOn ?? beginsOn(barrier.opens);

function shapes(barrier: Barrier, { px, leastLineMm = 0 }: Look): readonly Shape[] {
  const length = lengthOf(barrier.to[0] - barrier.from[0], barrier.to[1] - barrier.from[1]);
  const thickness = Math.max(barrier.thickness, leastLineMm);
  const bar = wallShape({ ...barrier, thickness }, Math.min(2, thickness / 4));
  const line = Math.max(1, px);
  const posts = [0, length].map((x) => circle(thickness * 0.75, { fill: POST }, [x, 0]));
  if (isOpen(barrier)) return [{ ...bar, stroke: RED, width: line, dash: [6, 5] }, ...posts];
  const stripe = Math.max(thickness * 1.5, 8);
  const stripes = Array.from({ length: Math.ceil(length / stripe / 2) }, (_, index): Shape => {
    const from = index * 2 * stripe;
    const size = [Math.min(stripe, length - from), thickness] as const;
    return { form: 'rect', at: [from, -thickness / 2], size, round: 0, fill: RED };
  });
  return [{ ...bar, fill: WHITE }, ...stripes, { ...bar, stroke: POST, width: line }, ...posts];
}
