import type { Texts } from '#core/texts';
import type { RunRefusal } from '#scene/run-refusal';

/** Why no run can begin in a course, in the pupil's words; they come with the first failure. */
export const failureTexts: Readonly<Record<RunRefusal['code'], Texts>> = {
  heap: {
    de: 'An mehr als {max} Stellen stehen Blöcke ineinander oder in anderen Dingen. Zieh sie auseinander oder lösche einige.',
    fr: 'À plus de {max} endroits, des blocs se trouvent les uns dans les autres ou dans d’autres objets. Écarte-les ou supprimes-en quelques-uns.',
    it: 'In più di {max} punti ci sono blocchi uno dentro l’altro o dentro altre cose. Allontanali o cancellane alcuni.',
    en: 'Blocks stand inside each other or inside other things at more than {max} places. Move them apart, or delete some.',
  },
  movers: {
    de: '{count} fahrende Hindernisse sind zu viele für einen Lauf; höchstens {max} gehen. Lösche einige.',
    fr: '{count} obstacles mobiles, c’est trop pour une simulation ; {max} au plus sont possibles. Supprimes-en quelques-uns.',
    it: '{count} ostacoli mobili sono troppi per una simulazione; ne vanno al massimo {max}. Cancellane alcuni.',
    en: '{count} moving obstacles are too many for a run; {max} are the most. Delete some.',
  },
  background: {
    de: 'Das Bild am Boden ist beschädigt. Nimm es neu auf oder entferne es.',
    fr: 'L’image au sol est endommagée. Ajoute-la de nouveau ou enlève-la.',
    it: 'L’immagine sul pavimento è danneggiata. Aggiungila di nuovo o toglila.',
    en: 'The picture on the floor is damaged. Take it in anew, or remove it.',
  },
};
