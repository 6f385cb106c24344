import type { Language } from '../../page/i18n/texts';

/** A sample program for the microcomputer alone: no course, no robot. Its comments and words are in the pupil's language. */
export interface BoardProgram {
  /** Name of its folder. */
  readonly id: string;
  readonly title: Readonly<Record<Language, string>>;
  readonly source: Readonly<Record<Language, string>>;
  /** Id of the only board it runs on, or `null`. */
  readonly board: string | null;
}

const sources = import.meta.glob<string>('../../../../courses/board/*/main.*.py', {
  query: '?raw',
  import: 'default',
  eager: true,
});

/** In the order of the lessons: what is seen, what is pressed, what is felt, what is sent and kept. */
const TITLES: Readonly<Record<string, Readonly<Record<Language, string>>>> = {
  heart: {
    de: 'Herz und Laufschrift',
    fr: 'Cœur et texte défilant',
    it: 'Cuore e testo che scorre',
    en: 'Heart and scrolling text',
  },
  counter: {
    de: 'Zähler mit Tasten',
    fr: 'Compteur avec boutons',
    it: 'Contatore con i pulsanti',
    en: 'Counter with buttons',
  },
  dice: { de: 'Würfel zum Schütteln', fr: 'Dé à secouer', it: 'Dado da scuotere', en: 'Dice to shake' },
  light: { de: 'Lichtmesser', fr: 'Mesurer la lumière', it: 'Misurare la luce', en: 'Light meter' },
  thermometer: { de: 'Thermometer', fr: 'Thermomètre', it: 'Termometro', en: 'Thermometer' },
  compass: { de: 'Kompassnadel', fr: 'Aiguille de boussole', it: 'Ago della bussola', en: 'Compass needle' },
  melody: { de: 'Melodie', fr: 'Mélodie', it: 'Melodia', en: 'Melody' },
  radio: { de: 'Nachrichten funken', fr: 'Messages par radio', it: 'Messaggi via radio', en: 'Messages by radio' },
  'data-log': { de: 'Daten aufzeichnen', fr: 'Noter des données', it: 'Registrare dati', en: 'Logging data' },
  calliope: {
    de: 'Calliope: Farblichter und Motoren',
    fr: 'Calliope : LED de couleur et moteurs',
    it: 'Calliope: LED colorati e motori',
    en: 'Calliope: colour lights and motors',
  },
};

const sourceOf = (id: string, language: Language): string =>
  sources[`../../../../courses/board/${id}/main.${language}.py`] ?? '';

/** Every sample program for the microcomputer alone. Imported only where they are offered: they are of no use before. */
export const boardPrograms: readonly BoardProgram[] = Object.entries(TITLES).map(([id, title]) => ({
  id,
  title,
  source: {
    de: sourceOf(id, 'de'),
    fr: sourceOf(id, 'fr'),
    it: sourceOf(id, 'it'),
    en: sourceOf(id, 'en'),
  },
  board: id === 'calliope' ? 'calliope-mini-3' : null,
}));

/** A text is one of ours, untouched by a pupil. */
export const isBoardProgram = (text: string): boolean =>
  boardPrograms.some(({ source }) => Object.values(source).includes(text));
