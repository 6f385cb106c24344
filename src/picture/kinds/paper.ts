import type { Paper } from '#scene/scene';

import { formOf, geometryOf } from '../form';
import type { Look } from '../look';
import { paints } from '../paints';
import { group, type Shape } from '../shapes';
import { boxFrame, type PictureKind } from './kind';

/**
 * Coloured sheets: filled to their edge, which has the ink of their colour. On paper true to scale only the edge: a sheet of
 * that colour is glued there.
 */
export const paper: PictureKind<Paper> = {
  ground: (paper, look) => [group(paper.at, sheet(paper, look), paper.angle)],
  paper: (paper) => [
    group(paper.at, [{ ...geometryOf(formOf(paper), 0, 0), stroke: paints[paper.color].ink, width: 0.6 }], paper.angle),
  ],
  frame: boxFrame,
};

function sheet(paper: Paper, { px }: Look): readonly Shape[] {
  const { fill, ink } = paints[paper.color];
  const line = Math.max(px, 1.5);
  const radius = Math.min(3, Math.min(...paper.size) / 6);
  return [
    { ...geometryOf(formOf(paper), 0, radius), fill, opacity: 0.85 },
    { ...geometryOf(formOf(paper), line / 2, radius), stroke: ink, width: line },
  ];
}
