import type { Stroke } from '#scene/scene';

import type { Look } from '../look';
import type { Paint, Shape } from '../shapes';
import type { PictureKind } from './kind';

/** Painted lines. */
export const stroke: PictureKind<Stroke> = {
  line: strokeShapes,
  // Printed black must be as dark as it goes: the robot's sensors look at it.
  paper: (stroke, { colors }) =>
    lined(stroke, [
      { width: stroke.width, stroke: stroke.color === 'black' ? '#000000' : colors.strokes[stroke.color] },
    ]),
  frame: () => null,
};

/** White, yellow and silver lines lie on one that is this many px wider, so that they remain visible on a light floor. */
export const RIM_PX = 1.5;

/** True if a light floor would swallow a line of this colour. */
export const needsRim = ({ color }: Pick<Stroke, 'color'>): boolean =>
  color === 'white' || color === 'yellow' || color === 'silver';

function strokeShapes(stroke: Stroke, { colors, px, leastLineMm = 0 }: Look): readonly Shape[] {
  const width = Math.max(stroke.width, leastLineMm);
  return lined(stroke, [
    ...(needsRim(stroke) ? [{ width: width + RIM_PX * px, stroke: colors.strokeEdge }] : []),
    { width, stroke: colors.strokes[stroke.color] },
  ]);
}

function lined({ points }: Stroke, paints: readonly Paint[]): readonly Shape[] {
  const lines = [points.length === 1 ? [...points, ...points] : points]; // a dot
  return paints.map((paint) => ({ form: 'lines', lines, cap: 'round', join: 'round', ...paint }));
}
