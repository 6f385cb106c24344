import type { Texts } from '#core/texts';
import type { LightForm, LightPlace } from './light-wish';

/** What a form is called in a list. */
export const formNames: Readonly<Record<LightForm, Texts>> = {
  ring: { de: 'Ring', en: 'Ring' },
  strip: { de: 'Streifen', en: 'Strip' },
  matrix: { de: 'Matrix, Zeile für Zeile', en: 'Matrix, row by row' },
  zigzag: { de: 'Matrix im Zickzack', en: 'Matrix, zigzag' },
};

export const placeNames: Readonly<Record<LightPlace, Texts>> = {
  board: { de: 'Neben dem Mikrocomputer', en: 'Beside the microcomputer' },
  robot: { de: 'Auf dem Roboter', en: 'On the robot' },
};

/** For screen readers: what it is, where, how many there are and how many are on. */
export const chainTexts: Readonly<Record<LightForm, Texts>> = {
  ring: {
    de: 'LED-Ring an Pin {pin}: {count} Lichter, {lit} leuchten',
    en: 'LED ring on pin {pin}: {count} lights, {lit} lit',
  },
  strip: {
    de: 'LED-Streifen an Pin {pin}: {count} Lichter, {lit} leuchten',
    en: 'LED strip on pin {pin}: {count} lights, {lit} lit',
  },
  matrix: {
    de: 'LED-Matrix an Pin {pin}: {count} Lichter, {lit} leuchten',
    en: 'LED matrix on pin {pin}: {count} lights, {lit} lit',
  },
  zigzag: {
    de: 'LED-Matrix an Pin {pin}: {count} Lichter, {lit} leuchten',
    en: 'LED matrix on pin {pin}: {count} lights, {lit} lit',
  },
};

export const lightTexts = {
  title: { de: 'Lichterkette an Pin {pin}', en: 'Lights on pin {pin}' },
  caption: { de: 'Pin {pin} · {count} Lichter', en: 'Pin {pin} · {count} lights' },
  onRobot: { de: 'auf dem Roboter', en: 'on the robot' },
  change: { de: 'Form und Platz ändern', en: 'Change form and place' },
  form: { de: 'Form', en: 'Form' },
  place: { de: 'Platz', en: 'Place' },
} satisfies Record<string, Texts>;

/** A pin as pupils write it: `2` for the wire `P2`. */
export const pinName = (wire: string): string => wire.replace(/^P(?=\d)/, '');
