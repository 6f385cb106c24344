/**
 * The Maqueen Mechanic kit "Loader": a shovel on two arms. Its size is chosen (no drawing is public): 64 mm wide and
 * 35 mm deep.
 */
import type { AttachmentType } from '../attachment';
import { attachLift, DOWN_DEG } from '../lift';
import { box } from '../mount';
import { attachmentTitles } from '../options';

export const loader: AttachmentType = {
  id: 'loader',
  title: attachmentTitles.loader,
  about: {
    de: 'Bei 110° liegt die Schaufel am Boden, bei 0° ist sie oben. Fahr gegen einen Block und heb ihn an.',
    fr: 'À 110°, la pelle est au sol, à 0° elle est en haut. Va contre un bloc et soulève-le.',
    it: 'A 110° la pala è a terra, a 0° è in alto. Va’ contro un blocco e sollevalo.',
    en: 'The shovel is on the floor at 110° and up at 0°. Drive against a block and lift it.',
  },
  restDeg: DOWN_DEG,
  attach: (context) => attachLift(context, { backMm: box(0, 6, -32, 32), plateMm: box(6, 41, -32, 32) }),
};
