import type { Texts } from '#core/texts';
import type { LightForm, LightPlace } from '../../work/settings/light-wish';

/** What a form is called in a list. */
export const formNames: Readonly<Record<LightForm, Texts>> = {
  ring: { de: 'Ring', fr: 'Anneau', it: 'Anello', en: 'Ring' },
  strip: { de: 'Streifen', fr: 'Bande', it: 'Striscia', en: 'Strip' },
  matrix: {
    de: 'Matrix, Zeile für Zeile',
    fr: 'Matrice, ligne par ligne',
    it: 'Matrice, riga per riga',
    en: 'Matrix, row by row',
  },
  zigzag: { de: 'Matrix im Zickzack', fr: 'Matrice en zigzag', it: 'Matrice a zigzag', en: 'Matrix, zigzag' },
};

export const placeNames: Readonly<Record<LightPlace, Texts>> = {
  board: {
    de: 'Neben dem Mikrocomputer',
    fr: 'À côté de la carte',
    it: 'Accanto alla scheda',
    en: 'Beside the microcomputer',
  },
  robot: { de: 'Auf dem Roboter', fr: 'Sur le robot', it: 'Sul robot', en: 'On the robot' },
};

/** For screen readers: what it is, where, how many there are and how many are on. */
export const chainTexts: Readonly<Record<LightForm, Texts>> = {
  ring: {
    de: 'LED-Ring an Pin {pin}: {count} Lichter, {lit} leuchten',
    fr: 'Anneau de LED à la broche {pin} : {count} lumières, {lit} allumées',
    it: 'Anello di LED al pin {pin}: {count} luci, {lit} accese',
    en: 'LED ring on pin {pin}: {count} lights, {lit} lit',
  },
  strip: {
    de: 'LED-Streifen an Pin {pin}: {count} Lichter, {lit} leuchten',
    fr: 'Bande de LED à la broche {pin} : {count} lumières, {lit} allumées',
    it: 'Striscia di LED al pin {pin}: {count} luci, {lit} accese',
    en: 'LED strip on pin {pin}: {count} lights, {lit} lit',
  },
  matrix: {
    de: 'LED-Matrix an Pin {pin}: {count} Lichter, {lit} leuchten',
    fr: 'Matrice de LED à la broche {pin} : {count} lumières, {lit} allumées',
    it: 'Matrice di LED al pin {pin}: {count} luci, {lit} accese',
    en: 'LED matrix on pin {pin}: {count} lights, {lit} lit',
  },
  zigzag: {
    de: 'LED-Matrix an Pin {pin}: {count} Lichter, {lit} leuchten',
    fr: 'Matrice de LED à la broche {pin} : {count} lumières, {lit} allumées',
    it: 'Matrice di LED al pin {pin}: {count} luci, {lit} accese',
    en: 'LED matrix on pin {pin}: {count} lights, {lit} lit',
  },
};

export const lightTexts = {
  title: {
    de: 'Lichterkette an Pin {pin}',
    fr: 'Lumières à la broche {pin}',
    it: 'Luci al pin {pin}',
    en: 'Lights on pin {pin}',
  },
  caption: {
    de: 'Pin {pin} · {count} Lichter',
    fr: 'Broche {pin} · {count} lumières',
    it: 'Pin {pin} · {count} luci',
    en: 'Pin {pin} · {count} lights',
  },
  onRobot: { de: 'auf dem Roboter', fr: 'sur le robot', it: 'sul robot', en: 'on the robot' },
  change: {
    de: 'Form und Platz ändern',
    fr: 'Changer la forme et la place',
    it: 'Cambia forma e posto',
    en: 'Change form and place',
  },
  form: { de: 'Form', fr: 'Forme', it: 'Forma', en: 'Form' },
  place: { de: 'Platz', fr: 'Place', it: 'Posto', en: 'Place' },
} satisfies Record<string, Texts>;

/** A pin as pupils write it: `2` for the wire `P2`. */
export const pinName = (wire: string): string => wire.replace(/^P(?=\d)/, '');
