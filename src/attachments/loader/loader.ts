/**
 * The Maqueen Mechanic kit "Loader": a shovel on two arms. Its size is chosen (no drawing is public): 64 mm wide and
 * 35 mm deep.
 */
import attachmentAbout from '../words/about';
import type { AttachmentType } from '../attachment';
import { attachLift, DOWN_DEG } from '../lift';
import { box } from '../mount';
import { attachmentTitles } from '../options';

export const loader: AttachmentType = {
  id: 'loader',
  title: attachmentTitles.loader,
  about: attachmentAbout.loader,
  restDeg: DOWN_DEG,
  attach: (context) => attachLift(context, { backMm: box(0, 6, -32, 32), plateMm: box(6, 41, -32, 32) }),
};
