import { mdiArrowLeftRightBold } from '@mdi/js';
import type { Mover } from '#scene/scene';

import { lightPalette as colors } from '../../arena/model/palette';
import { formOf } from '../../arena/picture/kinds/shape-path';
import { element, pathThrough } from './svg-write';
import type { PrintKind, ToPicture } from './kind';
import { toothed } from './spikes';
import { boxFrame, degrees, formSvg, icon } from './svg-parts';

/** Boxes that go to and fro, with their track. */
export const mover: PrintKind<Mover> = { layer: 3, svg: moverSvg };

function moverSvg(mover: Mover, to: ToPicture): string {
  const { at, to: end, size, spiked } = mover;
  const [from, turning] = [to(at), to(end)];
  const inner = formOf(spiked ? { ...mover, size: [size[0] * 0.6, size[1] * 0.6] } : mover);
  const short = Math.min(inner.sizeMm.x, inner.sizeMm.y);
  const frame = Math.min(3, short * 0.09);
  const wayDeg = degrees(Math.atan2(end[1] - at[1], end[0] - at[0]));
  const line = { fill: 'none', stroke: colors.moverInk, 'stroke-width': 2.5 };
  return (
    element('path', { ...line, d: pathThrough([from, turning]), 'stroke-dasharray': '7.5 6' }) +
    boxFrame(
      { at: end, angle: mover.angle },
      to,
      formSvg(formOf(mover), 0, 4, { ...line, 'stroke-dasharray': '6 5' }),
    ) +
    element('circle', {
      cx: turning[0],
      cy: turning[1],
      r: 6.5,
      fill: colors.floor,
      stroke: colors.moverInk,
      'stroke-width': 2.5,
    }) + // prettier-ignore
    boxFrame(
      mover,
      to,
      (spiked ? toothed(formOf(mover)) : '') +
        formSvg(inner, frame / 2, Math.min(5, short / 6), {
          fill: colors.moverLight,
          stroke: colors.moverInk,
          'stroke-width': frame,
        }) +
        element('g', { transform: `rotate(${String(mover.angle - wayDeg)})` }, icon(mdiArrowLeftRightBold, short * 0.72, colors.moverInk)), // prettier-ignore
    )
  );
}
