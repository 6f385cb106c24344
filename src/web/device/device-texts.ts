import type { Texts } from '#core/texts';

/** The words of the device panel; they come with it. */
export const deviceTexts = {
  gallery: { de: 'Roboter-Galerie', fr: 'Galerie des robots', it: 'Galleria dei robot', en: 'Robot gallery' },
  onBoard: { de: 'auf {board}', fr: 'sur {board}', it: 'su {board}', en: 'on {board}' },
  options: { de: '{robot} einrichten', fr: 'Régler le {robot}', it: 'Imposta il {robot}', en: 'Set up the {robot}' },
  asStart: { de: 'Zurücksetzen', fr: 'Réinitialiser', it: 'Azzera', en: 'Reset' },
  courseHas: {
    de: 'Vom Kurs: {choice}',
    fr: 'Du parcours : {choice}',
    it: 'Dal percorso: {choice}',
    en: 'From the course: {choice}',
  },
  reality: { de: 'Wirklichkeit', fr: 'Réalité', it: 'Realtà', en: 'Reality' },
  ideal: {
    de: 'Beide Motoren sind gleich stark, die Sensoren messen genau.',
    fr: 'Les deux moteurs ont la même force, les capteurs mesurent exactement.',
    it: 'I due motori hanno la stessa forza, i sensori misurano con precisione.',
    en: 'Both motors are equally strong, the sensors measure exactly.',
  },
  used: {
    de: 'Ein Motor zieht stärker, der Akku lässt nach, die Sensoren zittern, schräge Wände hört der Ultraschall schlecht.',
    fr: 'Un moteur tire plus fort, l’accu faiblit, les capteurs tremblent, les ultrasons entendent mal les murs obliques.',
    it: 'Un motore tira di più, la batteria cala, i sensori tremano, gli ultrasuoni sentono male i muri obliqui.',
    en: 'One motor pulls harder, the battery sags, the sensors tremble, slanted walls are hard to hear by ultrasound.',
  },
  number: { de: 'Roboter Nr.', fr: 'Robot n°', it: 'Robot n.', en: 'Robot no.' },
  another: { de: 'Anderer Roboter', fr: 'Un autre robot', it: 'Un altro robot', en: 'Another robot' },
  sameNumber: {
    de: 'Jede Nummer ist ein anderer Roboter; dieselbe Nummer gibt immer denselben.',
    fr: 'Chaque numéro est un autre robot ; le même numéro donne toujours le même.',
    it: 'Ogni numero è un altro robot; lo stesso numero dà sempre lo stesso.',
    en: 'Each number is another robot; the same number always gives the same one.',
  },
} as const satisfies Readonly<Record<string, Texts>>;

/** How real a robot can be, and what that is called. */
export const REALITIES: readonly { readonly value: number; readonly name: Texts }[] = [
  { value: 0, name: { de: 'ideal', fr: 'idéal', it: 'ideale', en: 'ideal' } },
  { value: 0.25, name: { de: 'fast neu', fr: 'presque neuf', it: 'quasi nuovo', en: 'almost new' } },
  { value: 0.5, name: { de: 'eingefahren', fr: 'rodé', it: 'rodato', en: 'worn in' } },
  { value: 0.75, name: { de: 'oft gebraucht', fr: 'souvent utilisé', it: 'usato spesso', en: 'often used' } },
  {
    value: 1,
    name: {
      de: 'wie ein alter Schulroboter',
      fr: 'comme un vieux robot d’école',
      it: 'come un vecchio robot di scuola',
      en: 'like an old school robot',
    },
  },
];
