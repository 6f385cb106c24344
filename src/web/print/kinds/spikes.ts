import { mdiAlert } from '@mdi/js';
import type { Point, Spikes } from '#scene/scene';

import { teeth } from '../../arena/picture/kinds/spikes';
import { lightPalette as colors } from '../../arena/model/palette';
import { element, pathThrough } from './svg-write';
import type { PrintKind } from './kind';
import { boxFrame, icon } from './svg-parts';

/** Spikes. */
export const spikes: PrintKind<Spikes> = {
  layer: 3,
  svg: (spikes, to) => boxFrame(spikes, to, spikesSvg(spikes.size)),
};

function spikesSvg([x, y]: Point): string {
  return toothed([x, y]) + icon(mdiAlert, Math.min(x, y) * 0.42, colors.spikesInk);
}

/** A box with teeth around the origin. */
export const toothed = ([x, y]: Point): string =>
  element('path', {
    d: pathThrough(
      teeth({ x, y }).map((place) => [place.x, place.y] as const),
      true,
    ),
    fill: colors.spikes,
    stroke: colors.spikesInk,
    'stroke-width': 1,
  });
