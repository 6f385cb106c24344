import type { Form } from '../../../pupil/arena/model/arena-model';
import { mdiAlert } from '@mdi/js';
import type { Spikes } from '#scene/scene';

import { teeth } from '../../../pupil/arena/picture/kinds/spikes';
import { lightPalette as colors } from '../../../pupil/arena/model/palette';
import { formOf, roomIn } from '../../../pupil/arena/picture/kinds/shape-path';
import { element, pathThrough } from './svg-write';
import type { PrintKind } from './kind';
import { boxFrame, icon, inRoom } from './svg-parts';

/** Spikes. */
export const spikes: PrintKind<Spikes> = {
  layer: 3,
  svg: (spikes, to) => boxFrame(spikes, to, spikesSvg(formOf(spikes))),
};

function spikesSvg(form: Form): string {
  const room = roomIn(form);
  return toothed(form) + inRoom(room, icon(mdiAlert, room.acrossMm * 0.42, colors.spikesInk));
}

/** A form with teeth around the origin. */
export const toothed = (form: Form): string =>
  element('path', {
    d: pathThrough(
      teeth(form).map((place) => [place.x, place.y] as const),
      true,
    ),
    fill: colors.spikes,
    stroke: colors.spikesInk,
    'stroke-width': 1,
  });
