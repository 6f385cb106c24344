/**
 * The Maqueen Mechanic kit "Forklift": two tines that go under a block and lift it. Lengths are chosen (no drawing is
 * public): the middle of a block of 3 to 8 cm that touches the mast is above the tines.
 */
import attachmentAbout from '../words/about';
import type { AttachmentType } from '../attachment';
import { attachLift, DOWN_DEG } from '../lift';
import { box } from '../mount';
import { attachmentTitles } from '../options';

export const forklift: AttachmentType = {
  id: 'forklift',
  title: attachmentTitles.forklift,
  about: attachmentAbout.forklift,
  restDeg: DOWN_DEG,
  attach: (context) => attachLift(context, { backMm: box(0, 8, -24, 24), plateMm: box(8, 58, -20, 20) }),
};
