import { mdiAlert } from '@mdi/js';
import type { Spikes } from '#scene/scene';

import { formOf, signRoomIn, type Form } from '../form';
import type { Look } from '../look';
import { group, type Shape } from '../shapes';
import { icon } from './block';
import { boxFrame, type PictureKind } from './kind';
import { toothed, toothedOutline } from './teeth';

/** Spikes: teeth around a dark body. */
export const spikes: PictureKind<Spikes> = {
  body: (spikes, look) => [group(spikes.at, spikesShapes(formOf(spikes), look), spikes.angle)],
  shade: (spikes, fill) => group(spikes.at, [{ ...toothedOutline(formOf(spikes)), fill }], spikes.angle),
  frame: boxFrame,
};

function spikesShapes(form: Form, look: Look): readonly Shape[] {
  const { at, acrossMm } = signRoomIn(form);
  return [toothed(form, look), group([at.x, at.y], icon(mdiAlert, acrossMm * 0.46, look.colors.spikesInk, look))];
}
