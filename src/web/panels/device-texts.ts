import type { Texts } from '#core/texts';

/** The words of the device panel; they come with it. */
export const deviceTexts = {
  gallery: { de: 'Roboter-Galerie', en: 'Robot gallery' },
  onBoard: { de: 'auf {board}', en: 'on {board}' },
  options: { de: '{robot} einrichten', en: 'Set up the {robot}' },
  asStart: { de: 'Zurücksetzen', en: 'Reset' },
  courseHas: { de: 'Vom Kurs: {choice}', en: 'From the course: {choice}' },
  reality: { de: 'Wirklichkeit', en: 'Reality' },
  ideal: {
    de: 'Beide Motoren sind gleich stark, die Sensoren messen genau.',
    en: 'Both motors are equally strong, the sensors measure exactly.',
  },
  used: {
    de: 'Ein Motor zieht stärker, der Akku lässt nach, die Sensoren zittern, schräge Wände hört der Ultraschall schlecht.',
    en: 'One motor pulls harder, the battery sags, the sensors tremble, slanted walls are hard to hear by ultrasound.',
  },
  number: { de: 'Roboter Nr.', en: 'Robot no.' },
  another: { de: 'Anderer Roboter', en: 'Another robot' },
  sameNumber: {
    de: 'Jede Nummer ist ein anderer Roboter; dieselbe Nummer gibt immer denselben.',
    en: 'Each number is another robot; the same number always gives the same one.',
  },
} as const satisfies Readonly<Record<string, Texts>>;

/** How real a robot can be, and what that is called. */
export const REALITIES: readonly { readonly value: number; readonly name: Texts }[] = [
  { value: 0, name: { de: 'ideal', en: 'ideal' } },
  { value: 0.25, name: { de: 'fast neu', en: 'almost new' } },
  { value: 0.5, name: { de: 'eingefahren', en: 'worn in' } },
  { value: 0.75, name: { de: 'oft gebraucht', en: 'often used' } },
  { value: 1, name: { de: 'wie ein alter Schulroboter', en: 'like an old school robot' } },
];
