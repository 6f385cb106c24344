import { stopsOf } from '#scene/kinds/mover-way';
import type { Mover, Point } from '#scene/scene';

import { lightPalette as colors } from '../../../pupil/arena/model/palette';
import { closedWay, moverSign, moverSignRad } from '../../../pupil/arena/picture/kinds/mover-sign';
import { formOf } from '../../../pupil/arena/picture/kinds/shape-path';
import { shownLanguage } from '../../../kit/i18n';
import { numberText } from '../../../kit/i18n/number-text';
import { element, pathThrough } from './svg-write';
import type { PrintKind, ToPicture } from './kind';
import { toothed } from './spikes';
import { boxFrame, degrees, formSvg, icon, turned, written } from './svg-parts';

/** Boxes that move by themselves, with their way. */
export const mover: PrintKind<Mover> = { layer: 3, svg: moverSvg };

const LINE = { fill: 'none', stroke: colors.moverInk, 'stroke-width': 2.5 };

function moverSvg(mover: Mover, to: ToPicture): string {
  const { size, spiked } = mover;
  const inner = formOf(spiked ? { ...mover, size: [size[0] * 0.6, size[1] * 0.6] } : mover);
  const short = Math.min(inner.sizeMm.x, inner.sizeMm.y);
  const frame = Math.min(3, short * 0.09);
  const upright = mover.angle - degrees(moverSignRad(mover));
  return (
    (mover.chases ? reachSvg(mover, to) : waySvg(mover, to)) +
    boxFrame(
      mover,
      to,
      (spiked ? toothed(formOf(mover)) : '') +
        formSvg(inner, frame / 2, Math.min(5, short / 6), {
          fill: colors.moverLight,
          stroke: colors.moverInk,
          'stroke-width': frame,
        }) +
        element(
          'g',
          { transform: `rotate(${String(upright)})` },
          icon(moverSign(mover), short * 0.72, colors.moverInk),
        ),
    )
  );
}

/** Dashes from stop to stop, the outline where it turns round, a circle and the seconds of its wait at each. */
function waySvg(mover: Mover, to: ToPicture): string {
  const stops = stopsOf(mover);
  const [last] = stops.slice(-1);
  if (last === undefined || stops.length < 2) return '';
  const way = closedWay(mover, stops.map(({ at }) => at)).map(to); // prettier-ignore
  const outline = formSvg(formOf(mover), 0, 4, { ...LINE, 'stroke-dasharray': '6 5' });
  const offMm = Math.min(...mover.size) / 2 + 12;
  return [
    element('path', { ...LINE, d: pathThrough(way), 'stroke-dasharray': '7.5 6' }),
    mover.loops ? '' : boxFrame({ at: last.at, angle: mover.angle }, to, outline),
    ...stops.slice(1).map(({ at }) => stopSvg(to(at))),
    ...stops.filter(({ wait }) => wait > 0).map(({ at, wait }) => {
      const text = `${numberText(wait, shownLanguage())} s`;
      const [x, y] = to(at);
      return element('g', { transform: turned([x + offMm, y - offMm], 0) }, written(text, 16, colors.moverInk, 0));
    }),
  ].join(''); // prettier-ignore
}

const stopSvg = ([cx, cy]: Point): string => element('circle', { ...LINE, cx, cy, r: 6.5, fill: colors.floor });

/** As far as it notices robots. */
function reachSvg({ at, chases }: Mover, to: ToPicture): string {
  const [cx, cy] = to(at);
  if (chases?.reach === undefined) return '';
  return element('circle', {
    ...LINE,
    cx,
    cy,
    r: chases.reach,
    'stroke-dasharray': '0 7.5',
    'stroke-linecap': 'round',
  });
}
