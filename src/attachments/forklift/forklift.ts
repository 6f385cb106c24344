/**
 * The Maqueen Mechanic kit "Forklift": two tines that go under a block and lift it. Lengths are chosen (no drawing is
 * public): the middle of a block of 3 to 8 cm that touches the mast lies above the tines.
 */
import type { AttachmentType } from '../attachment';
import { attachLift, DOWN_DEG } from '../lift';
import { box } from '../mount';
import { attachmentTitles } from '../options';

export const forklift: AttachmentType = {
  id: 'forklift',
  title: attachmentTitles.forklift,
  about: {
    de: 'Bei 110° liegt die Gabel am Boden, bei 0° ist sie oben. Fahr unter einen Block und heb ihn an.',
    fr: 'À 110°, la fourche est au sol, à 0° elle est en haut. Va sous un bloc et soulève-le.',
    it: 'A 110° la forca è a terra, a 0° è in alto. Va’ sotto un blocco e sollevalo.',
    en: 'The fork is on the floor at 110° and up at 0°. Drive under a block and lift it.',
  },
  restDeg: DOWN_DEG,
  attach: (context) => attachLift(context, { backMm: box(0, 8, -24, 24), plateMm: box(8, 58, -20, 20) }),
};
